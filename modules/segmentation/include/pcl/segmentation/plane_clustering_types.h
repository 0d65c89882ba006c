#pragma once

#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief What PlaneHypothesisClustering tells about its last run. \ingroup segmentation
 */
struct PlaneClusteringReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< not finite
  std::size_t hypotheses = 0;     ///< points with a normal, off creases
  std::size_t planes = 0;
  std::size_t points_on_planes = 0;
  std::size_t small_regions = 0;  ///< too small, or nobody to judge them
  std::size_t curved_regions = 0; ///< grown, but no plane
  std::size_t points_on_curved = 0;
  std::size_t refuted_regions =
      0;                  ///< grown, but the source's points do not lie on them
  std::size_t merged = 0; ///< regions that are of the plane of another one

  std::size_t regular_planes = 0; ///< turned to be parallel or upright to larger ones
  double largest_turn = 0;        ///< radians; of these

  double spacing = 0;        ///< metres, between neighbouring points
  double sigma = 0;          ///< metres, noise of the points across their surface
  double plane_distance = 0; ///< metres; W_t that was used
};

} // namespace pcl
