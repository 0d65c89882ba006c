#pragma once

#include "case_list.h"

namespace pcl::acmap::test {

/** \name What is ugly, as the page has it
 * \{ */
constexpr const char* nan_points = "no point is a number";
constexpr const char* one_point = "one point";
constexpr const char* doubled_points = "each point twice";
constexpr const char* vast_points = "a wall of 10³⁰ m";
constexpr const char* far_points = "points 1 mm apart at 10⁸ m";
constexpr const char* millimetre_points = "a wall in millimetres";
constexpr const char* odd_cloud = "Messung Nr. 1/Wand für 測量.pcd";

constexpr const char* nan_observation = "an observation without a number";
constexpr const char* nan_observations = "both observations without a number";
constexpr const char* one_pixel = "an observation of one point";
constexpr const char* doubled_observation = "an observation that is there twice";
constexpr const char* no_z = "an observation without `z`";
constexpr const char* vast_observations = "observations of 10³⁰ m";
constexpr const char* millimetre_observations = "observations in millimetres";
constexpr const char* odd_folder = "Messung Nr. 1/Aufnahmen 測量";

constexpr const char* nan_rig = "`shots/rig.yaml` with `focal_length: .nan`";
constexpr const char* one_frame = "a session with one frame";
constexpr const char* doubled_frame = "a frame that is there twice";
constexpr const char* strange_rig = "`shots/rig.yaml` with a key that is none";
constexpr const char* vast_rig = "`shots/rig.yaml` with `focal_length: 1e30`";
constexpr const char* millimetre_rig = "`shots/rig.yaml` with baselines in millimetres";
/** \} */

/** \brief Returns the command line for an input with any name. */
using CommandFor = std::function<std::vector<std::string>(const std::string& input)>;

/** \brief Cases of a tool that reads one cloud. \param[in] outcomes see CaseList */
std::vector<UglyCase>
cloudCases(const CommandFor& command,
           const std::map<std::string, UglyOutcome>& outcomes);

/** \brief Cases of a tool that reads a folder of two observations with their poses.
 * \param[in] others puts further inputs into the folder */
std::vector<UglyCase>
sequenceCases(
    const CommandFor& command,
    const std::map<std::string, UglyOutcome>& outcomes,
    const CaseList::Prepare& others = [](const TemporaryFolder&) {});

/** \brief Results of most tools for \ref sessionCases, a lost frame is reported, all
 * other cases fail. */
std::map<std::string, UglyOutcome>
sessionOutcomes();

/** \brief Cases of a tool that reads a raw session of two observations. */
std::vector<UglyCase>
sessionCases(
    const CommandFor& command,
    const std::map<std::string, UglyOutcome>& outcomes,
    const CaseList::Prepare& others = [](const TemporaryFolder&) {});

} // namespace pcl::acmap::test
