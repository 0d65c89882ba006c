#pragma once

#include "plan_extent.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief A map from above: how many points lie over each pixel. */
class PlanPicture {
public:
  explicit PlanPicture(const PlanExtent& extent);

  /** \brief Counts a point; one outside of the extent, or not finite, is left out. */
  void
  add(const Eigen::Vector3d& in_map);

  /** \brief The points as darkness, by the logarithm of their number, the way of the
   * sensor as a line with a mark at its begin, and a scale bar. */
  RgbImage
  draw(const std::vector<Eigen::Isometry3d>& poses, const Color& color) const;

private:
  PlanExtent extent_;
  std::vector<std::uint32_t> counts_;
};

/** \brief Two plans of one extent beside each other. */
RgbImage
beside(const RgbImage& left, const RgbImage& right);

} // namespace pcl::acmap
