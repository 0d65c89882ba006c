#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The report of a run of the whole chain as an HTML page, which needs no other
 * file and no network. Values that are missing in the report are left out.
 * \param[in] report as report.json has it, with finite numbers and valid texts
 * \param[in] picture_folder folder of the files in its "pictures", and of energy.png */
std::string
reportPage(const nlohmann::ordered_json& report, const std::string& picture_folder);

/** \brief The text of report_page.html, which the build makes a part of the library. */
const char*
reportPageTemplate();

} // namespace pcl::acmap
