#pragma once

#include "patch_fitting_traits.h"

#include <pcl/segmentation/box_fitting.h>

#include <cmath>

namespace pcl::acmap::test {

struct BoxFittingTraits : PatchFittingTraits<BoxFittingTraits, BoxFitting, BoxPatch> {
  static constexpr const char* header =
      "segmentation/include/pcl/segmentation/box_fitting.h";

  static bool
  areSame(const BoxPatch& a, const BoxPatch& b)
  {
    for (std::size_t side = 0; side < a.faces.size(); ++side)
      if (a.faces[side].kind != b.faces[side].kind ||
          a.faces[side].plane != b.faces[side].plane)
        return false;
    return a.center == b.center && a.axes == b.axes && a.size == b.size &&
           a.slant == b.slant && a.covariance == b.covariance &&
           a.template_id == b.template_id && a.saved_bits == b.saved_bits;
  }

  /** A cube on a floor. */
  static std::vector<PlanePatch>
  planesLike(const PlanePatch& largest)
  {
    const double edge = std::sqrt(largest.area);
    const Eigen::Vector3d u = edge * largest.axis_u, v = edge * largest.axis_v,
                          n = u.cross(v) / edge;
    std::vector<PlanePatch> planes;
    for (const Eigen::Vector3d& way : {u, v}) {
      const Eigen::Vector3d across = n.cross(way) / edge;
      planes.push_back(square(largest, largest.center + way / 2, across, n));
      planes.push_back(square(largest, largest.center - way / 2, n, across));
    }
    planes.push_back(square(largest, largest.center + n / 2, u, v));
    planes.push_back(square(largest, largest.center - n / 2, 3 * u, 3 * v));
    return planes;
  }
};

} // namespace pcl::acmap::test
