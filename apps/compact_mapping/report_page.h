#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The report of a run of the whole chain as an HTML page, which needs no other
 * file and no network. Values that are missing in the report are left out.
 * \param[in] report as the chain writes it into report.json
 * \param[in] picture_folder folder of the files in its "pictures", and of energy.png */
std::string
reportPage(const nlohmann::ordered_json& report, const std::string& picture_folder);

/** \brief Writes \ref reportPage into a file.
 * \throws OutputFileException when it could not be written completely */
void
saveReportPage(const std::string& path,
               const nlohmann::ordered_json& report,
               const std::string& picture_folder);

/** \brief The text of report_page.html, which the build makes a part of the program. */
const char*
reportPageTemplate();

} // namespace pcl::acmap
