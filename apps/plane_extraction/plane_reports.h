#pragma once

#include "tool.h"

#include <pcl/core/plane_patch.h>
#include <pcl/pipeline/plane_mapping_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief Reports all steps that found planes: warnings, lines of the summary, parts of the
 * JSON report and seconds. */
void
tellMapping(Tool& tool, const PlaneMappingReport& report);

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
