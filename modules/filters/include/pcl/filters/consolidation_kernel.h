#pragma once

#include <pcl/core/export.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/core/sensor_view.h>
#include <pcl/core/voxel_moments.h>
#include <pcl/filters/consolidation_types.h>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref consolidatePoints; see VoxelConsolidation. */
struct ConsolidationSettings {
  double voxel_size = 0; ///< metres; 0: automatic
  bool keep_sources = false;
  unsigned threads = 0; ///< 0: all
};

/** \brief The point that stands for one side of a voxel's surface. */
struct Representative {
  Eigen::Vector3f point;
  Eigen::Vector3f normal; ///< unit, towards the sensor where known; NaN without a plane
  float curvature = 0;    ///< least variance over the sum of all three, as PCL's
  std::int32_t witness =
      0; ///< position in the view of the source nearest to its sensor
  std::array<std::uint8_t, 3> color{}; ///< mean red, green, blue of the sources
};

struct Consolidation {
  std::vector<Representative> representatives;

  /** \brief For each position in the view its representative, -1 without one; empty
   * unless the sources were to be kept. */
  std::vector<std::int32_t> representative_of;
};

/** \brief The kernel behind VoxelConsolidation, free of PCL's point types.
 * \param[out] report counts, seconds, remarks; begun anew
 * \throws CancelledException when the progress was told to stop \ingroup filters */
ACMAP_EXPORT Consolidation
consolidatePoints(const PointView& points,
                  const SensorView& sensors,
                  const ColorView& colors,
                  const ConsolidationSettings& settings,
                  const Progress& progress,
                  ConsolidationReport& report);

} // namespace pcl::acmap
