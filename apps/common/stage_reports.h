#pragma once

#include "stage_log.h"

#include <pcl/core/report.h>
#include <pcl/features/voting_types.h>
#include <pcl/filters/consolidation_types.h>
#include <pcl/filters/depth_refinement_types.h>
#include <pcl/segmentation/depth_plane_types.h>
#include <pcl/segmentation/plane_clustering_types.h>
#include <pcl/surface/dewall_types.h>

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The fields of a stage's report, and its seconds; remarks are not included. */
template <typename StageReport>
nlohmann::ordered_json
jsonOf(const StageReport& report)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  visitFields(report,
              [&json](const char* name, const auto& value) { json[name] = value; });
  json["seconds"] = secondsOf(report);
  return json;
}

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
