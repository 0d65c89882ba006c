#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/progress.h>
#include <pcl/core/sensor_view.h>
#include <pcl/filters/consolidation_kernel.h>

#include <vector>

namespace pcl::acmap {

/** \brief A cloud after its consolidation. */
struct ConsolidatedCloud {
  PointCloudFile file; ///< with the remarks of the cloud that it was made of

  /** \brief The points and normals of its rows, and of which row the sources are. */
  Consolidation consolidation;
};

/** \brief Consolidates a cloud with all its fields, as VoxelConsolidation does a typed
 * one: each row is that of a source, with place, colour, normal, curvature and sigma made
 * anew.
 * \param[in] sensors who saw the points of the file
 * \param[out] report counts, seconds, remarks */
ConsolidatedCloud
consolidatedCloud(const PointCloudFile& file,
                  const SensorView& sensors,
                  const ConsolidationSettings& settings,
                  const ProgressCallback& progress,
                  ConsolidationReport& report);

} // namespace pcl::acmap
