#pragma once

#include <pcl/core/report.h>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief What a tool, or one stage of it, has to tell. */
struct Told {
  std::vector<std::pair<std::string, std::string>> lines; ///< of the summary
  nlohmann::ordered_json details = nlohmann::ordered_json::object();
  Report report; ///< seconds of each step, warnings
};

/** \brief For a report: "seconds", "summary", "warnings", "details". */
nlohmann::ordered_json
jsonOf(const Told& told);

/** \brief What \ref jsonOf gave.
 * \throws nlohmann::json::exception when it is something else */
Told
toldIn(const nlohmann::ordered_json& json);

/** \brief Of all steps. */
double
totalSeconds(const Told& told);

} // namespace pcl::acmap
