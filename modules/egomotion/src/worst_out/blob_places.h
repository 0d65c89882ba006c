#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief The places of a cloud whose type is not known: its fields x, y and z.
 * \throws BadArgumentException without a cloud, where a field is missing or no single
 * float, or where there is less data than the cloud claims */
std::vector<Eigen::Vector3f>
placesOf(const PCLPointCloud2::ConstPtr& cloud);

} // namespace pcl::acmap
