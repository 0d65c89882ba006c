#pragma once

#include "tool.h"

#include <pcl/core/plane_patch.h>
#include <pcl/features/voting_types.h>
#include <pcl/segmentation/depth_plane_types.h>
#include <pcl/segmentation/plane_clustering_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief The fields of a stage's report, its seconds and its remarks. */
nlohmann::ordered_json
jsonOf(const VotingReport& report);

nlohmann::ordered_json
jsonOf(const PlaneClusteringReport& report);

nlohmann::ordered_json
jsonOf(const DepthPlaneReport& report);

/** \brief Lines of the summary: how many planes, the share of the points on them, and
 * each plane, or of many the largest ones.
 * \param[in] labels for each point of the input its plane, -1 for none
 * \param[in] points of the input that are finite */
void
tellPlanes(Tool& tool,
           const std::vector<PlanePatch>& planes,
           const std::vector<std::int32_t>& labels,
           std::size_t points);

} // namespace pcl::acmap
