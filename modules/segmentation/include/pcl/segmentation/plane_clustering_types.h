#pragma once

#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of PlaneHypothesisClustering. \ingroup segmentation */
struct PlaneClusteringReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< not finite
  std::size_t hypotheses = 0;     ///< points with a normal, off creases
  std::size_t planes = 0;
  std::size_t points_on_planes = 0;
  std::size_t small_regions = 0;  ///< too small, or unverifiable without a source
  std::size_t curved_regions = 0; ///< grown, but not planar
  std::size_t points_on_curved = 0;
  std::size_t refuted_regions = 0; ///< not confirmed by the source
  std::size_t merged = 0;          ///< regions that were merged into another plane

  std::size_t regular_planes = 0; ///< made parallel or perpendicular to larger
  double largest_turn = 0;        ///< radians; maximum rotation of these

  double spacing = 0;        ///< metres; between neighbouring points
  double sigma = 0;          ///< metres; noise of the points along their normals
  double plane_distance = 0; ///< metres; W_t that was used
};

} // namespace pcl
