#pragma once

#include "tool.h"

#include <pcl/core/plane_patch.h>
#include <pcl/pipeline/plane_mapping_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief Reports all steps of the plane extraction: warnings, summary, JSON report and
 * seconds. */
void
tellMapping(Tool& tool, const PlaneMappingReport& report);

/** \brief Adds lines to the summary: the number of planes, the fraction of the points
 * on them, and each plane, or the largest ones if there are many.
 * \param[in] labels plane of each point of the input, -1 for none
 * \param[in] points number of finite points of the input */
void
tellPlanes(Tool& tool,
           const std::vector<PlanePatch>& planes,
           const std::vector<std::int32_t>& labels,
           std::size_t points);

} // namespace pcl::acmap
