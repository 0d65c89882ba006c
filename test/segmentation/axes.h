#pragma once

#include <Eigen/Core>

namespace pcl::acmap::test {

inline const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
inline const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
inline const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();

} // namespace pcl::acmap::test
