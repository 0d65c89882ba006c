#pragma once

#include <pcl/core/export.h>
#include <pcl/core/planar_pose.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief One sweep of a planar laser. Beam i points along first_angle + i angle_step,
 * measured from z (forward, 0) towards x (right, pi / 2). \ingroup core */
struct PlanarScan {
  std::vector<float> ranges; ///< metres; no echo if not in (0, maximum_range)
  double first_angle = 0;    ///< radians
  double angle_step = 0;     ///< radians; its sign is the direction of the sweep
  float maximum_range = 0;   ///< metres; beams without an echo read this value or more
  PlanarPose pose;           ///< of the laser in the map
  double stamp = 0;          ///< seconds
};

/** \brief Lowers the maximum range of scans of one laser to below the reading that stands for
 * a missing echo, if many beams have the same one, otherwise to above their largest reading.
 * \param[in,out] scans with the maximum range of the laser, infinity if it is not known
 * \ingroup core */
ACMAP_EXPORT void
excludeMissingEchoes(std::vector<PlanarScan>& scans);

/** \brief A scan as points of the XZ plane. \ingroup core */
struct PlanarScanPoints {
  /** In the frame of the laser, y = 0. The normal, towards the laser, is that of the
   * line through the neighbouring echoes, NaN if they are not on a line. */
  PointCloud<PointNormal>::Ptr cloud;
  std::vector<float> weights;    ///< metres of wall that each point represents
  std::size_t missing_beams = 0; ///< number of beams without an echo
};

/** \brief Converts echoes to points.
 * \throws BadArgumentException when an angle is not finite \ingroup core */
ACMAP_EXPORT PlanarScanPoints
pointsOf(const PlanarScan& scan);

} // namespace pcl
