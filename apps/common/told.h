#pragma once

#include <pcl/core/report.h>

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief The report of a tool, or of one of its stages. */
struct Told {
  std::vector<std::pair<std::string, std::string>> lines; ///< of the summary
  nlohmann::ordered_json details = nlohmann::ordered_json::object();
  Report report; ///< seconds of each step, warnings
};

/** \brief Report as JSON: "seconds", "summary", "warnings", "details". */
nlohmann::ordered_json
jsonOf(const Told& told);

/** \brief Reads the output of \ref jsonOf.
 * \throws nlohmann::json::exception when it has another form */
Told
toldIn(const nlohmann::ordered_json& json);

/** \brief Sum over all steps. */
double
totalSeconds(const Told& told);

} // namespace pcl::acmap
