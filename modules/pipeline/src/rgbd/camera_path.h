#pragma once

#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief Indices that sort the stamps; equal stamps keep their order. */
std::vector<std::size_t>
risingOrder(const std::vector<double>& stamps);

/** \brief Interpolates the camera's pose between known poses that are close enough in
 * time. */
class CameraPath {
public:
  /** \param[in] gap seconds between a time and the poses before and after it
   * \param[in] gap_alone seconds to a pose, if the other one is missing */
  CameraPath(const Trajectory& trajectory, double gap, double gap_alone);

  CameraPath(const Trajectory& trajectory, double gap)
  : CameraPath(trajectory, gap, gap)
  {}

  /** \brief Interpolates between the poses before and after if both are close enough,
   * otherwise returns the close one of them. */
  std::optional<Eigen::Isometry3d>
  at(double stamp) const;

private:
  Eigen::Isometry3d
  between(std::size_t after, double stamp) const;

  double gap_, gap_alone_;
  std::vector<double> stamps_;
  std::vector<Eigen::Isometry3d> poses_;
};

} // namespace pcl::acmap
