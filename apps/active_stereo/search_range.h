#pragma once

#include <pcl/core/trinocular_rig.h>

#include <string>

namespace pcl::acmap {

/** \brief The disparities that are searched. */
struct SearchRange {
  int least = 0; ///< px
  int count = 0; ///< number of disparities, starting at the minimum

  int
  most() const
  {
    return least + count - 1;
  }
};

/** \brief Disparities between two depths, extended by one pixel at both ends, and
 * limited by the size of the image and the range of the matcher.
 * \param[in] rig with a neighbour
 * \param[in] nearest metres
 * \param[in] farthest metres, above the nearest
 * \throws UsageError when the image is too small for any of them */
SearchRange
disparitiesBetween(const TrinocularRig& rig, double nearest, double farthest);

/** \brief Depth of a disparity, metres. */
double
depthOf(const TrinocularRig& rig, double disparity);

} // namespace pcl::acmap
