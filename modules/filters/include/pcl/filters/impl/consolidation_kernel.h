#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/voxel_moments.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/progress.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/core/sensor_view.h>
#include <pcl/filters/consolidation_types.h>

#include <array>

namespace pcl::acmap {

/** \brief Settings of \ref consolidatePoints; see VoxelConsolidation. */
struct ConsolidationSettings {
  double voxel_size = 0; ///< metres; 0: automatic
  bool keep_sources = false;
  unsigned threads = 0; ///< 0: all
};

/** \brief The point that represents one side of the surface of a voxel. */
struct Representative {
  Eigen::Vector3f point;
  Eigen::Vector3f normal; ///< unit, towards the sensor if known; NaN without a plane
  /** \brief Smallest variance divided by the sum of all three, as in PCL. */
  float curvature = 0;
  std::int32_t witness = 0;            ///< index of the source closest to its sensor
  std::array<std::uint8_t, 3> color{}; ///< mean red, green, blue of the sources
};

struct Consolidation {
  LargeVector<Representative> representatives;

  /** \brief For each index in the view the index of its representative, -1 if there is
   * none; empty unless the sources are kept. */
  PointLabels representative_of;
};

/** \brief Implementation of VoxelConsolidation, independent of PCL's point types.
 * \param[out] report counts, seconds, remarks; reset at the start
 * \throws CancelledException when the progress callback requested it \ingroup filters
 */
ACMAP_EXPORT Consolidation
consolidatePoints(const PointView& points,
                  const SensorView& sensors,
                  const ColorView& colors,
                  const ConsolidationSettings& settings,
                  const Progress& progress,
                  ConsolidationReport& report);

} // namespace pcl::acmap
