#pragma once

#include "consolidated_cloud.h"
#include "tool.h"

namespace pcl::acmap {

/** \brief No edge of a mesh of consolidated points is longer, in voxels: it reaches over
 * the jitter of representatives. */
inline constexpr double edges_of_voxel = 2.5;

/** \brief Consolidates a file's cloud as a step of a tool: with its progress, warnings,
 * line of the summary and part of the report.
 * \param[in] settings threads are the tool's
 * \throws UsageError where the user's `--consolidate` is larger than the cloud */
ConsolidatedCloud
consolidateInput(Tool& tool,
                 const PointCloudFile& file,
                 const SensorView& sensors,
                 ConsolidationSettings settings,
                 ConsolidationReport& report);

} // namespace pcl::acmap
