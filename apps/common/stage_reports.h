#pragma once

#include "fields_json.h"
#include "stage_log.h"

#include <pcl/core/noise_scale.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/filters/depth_refinement_types.h>

#include <string>

namespace pcl::acmap {

/** \brief Adds a line to the summary and a part to the JSON report. */
void
tellConsolidation(const ConsolidationReport& report, StageLog& log);

void
tellDepthNoise(const NoiseScale::InverseDepth& noise, StageLog& log);

void
tellRefinement(const DepthRefinementReport& report, StageLog& log);

/** \brief A fraction as text, in %. */
std::string
percent(std::size_t part, std::size_t whole);

} // namespace pcl::acmap
