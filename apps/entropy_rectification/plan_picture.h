#pragma once

#include "plan_extent.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A map from above: the number of points per pixel. */
class PlanPicture {
public:
  explicit PlanPicture(const PlanExtent& extent);

  /** \brief Counts a point, unless it is outside of the extent or not finite. */
  void
  add(const Eigen::Vector3d& in_map);

  /** \brief Draws the logarithm of the number of points as darkness, the trajectory of
   * the sensor as a line with a mark at its start, and a scale bar. */
  RgbImage
  draw(const std::vector<Eigen::Isometry3d>& poses, const Color& color) const;

private:
  PlanExtent extent_;
  std::vector<std::uint32_t> counts_;
};

/** \brief Two plans of the same extent side by side. */
RgbImage
beside(const RgbImage& left, const RgbImage& right);

} // namespace pcl::acmap
