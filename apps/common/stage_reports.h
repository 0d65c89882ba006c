#pragma once

#include "stage_log.h"

#include <pcl/core/cloud_assessment_types.h>
#include <pcl/core/fields_json.h>
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

/** \brief Tells how the columns of a text were understood; nothing for other files. */
void
tellColumns(const std::string& columns, StageLog& log);

/** \brief Tells what is assumed of a cloud and was not stated: the columns of a text, the up
 * direction, the sensor and the noise, a line each with the option that states another; and all in the JSON report. */
void
tellAssessment(const CloudAssessmentReport& report, StageLog& log);

/** \brief A finding as text, with its evidence and the option that states another. */
std::string
describe(const UpEvidence& up);

std::string
describe(const SensorEvidence& sensor);

/** \brief The unit of a cloud as text. */
std::string
describe(const CloudAssessmentReport::Unit& unit);

/** \brief A fraction as text, in %. */
std::string
percent(std::size_t part, std::size_t whole);

} // namespace pcl::acmap
