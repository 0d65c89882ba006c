#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/progress.h>
#include <pcl/filters/consolidation_types.h>

#include <string>

namespace pcl::acmap {

/** \brief How a file's cloud is to be consolidated. */
struct CloudConsolidation {
  double voxel_size = 0; ///< metres; 0: automatic
  unsigned threads = 0;  ///< 0: all
  double scale = 1;      ///< metres in a unit of the trajectory beside the file
};

/** \brief Consolidates a cloud with all its fields, as VoxelConsolidation does a typed
 * one: each row is that of a source, with place, colour, normal, curvature and sigma made
 * anew. Points with a field `view` were seen from the poses of the `trajectory.txt` beside
 * the file, others from the sensor of the cloud.
 * \param[in] path of the file that the cloud came from
 * \param[out] report counts, seconds, remarks
 * \throws InputFileException when the trajectory cannot be read */
PointCloudFile
consolidatedCloud(const PointCloudFile& file,
                  const std::string& path,
                  const CloudConsolidation& settings,
                  const ProgressCallback& progress,
                  ConsolidationReport& report);

} // namespace pcl::acmap
