#pragma once

#include "patch_fitting_traits.h"

#include <pcl/segmentation/recess_fitting.h>

#include <cmath>

namespace pcl::acmap::test {

struct RecessFittingTraits
: PatchFittingTraits<RecessFittingTraits, RecessFitting, RecessPatch> {
  static constexpr const char* header =
      "segmentation/include/pcl/segmentation/recess_fitting.h";

  static bool
  areSame(const RecessPatch& a, const RecessPatch& b)
  {
    return a.center == b.center && a.axes == b.axes && a.size == b.size &&
           a.wall == b.wall && a.leaf == b.leaf && a.reaches_floor == b.reaches_floor &&
           a.covariance == b.covariance && a.template_id == b.template_id &&
           a.saved_bits == b.saved_bits;
  }

  /** A niche in a wall above a floor. */
  static std::vector<PlanePatch>
  planesLike(const PlanePatch& largest)
  {
    const double edge = std::sqrt(largest.area);
    const Eigen::Vector3d right = edge * Eigen::Vector3d::UnitX(),
                          up = -edge * Eigen::Vector3d::UnitY(),
                          back = edge * Eigen::Vector3d::UnitZ();
    PlanePatch wall = square(largest, {0, 0, 0}, 3 * right, 3 * up);
    const PlanePatch opening = square(largest, {0, 0, 0}, up, right);
    wall.polygons[0].holes.push_back(opening.polygons[0].outer);
    return {wall,
            square(largest, {0, 0, 0.1}, right, up),
            square(largest, -1.5 * up - 3 * back, 3 * right, 6 * back)};
  }
};

} // namespace pcl::acmap::test
