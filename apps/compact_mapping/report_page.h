#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The report of a run of the whole chain as a page for a browser, which needs no
 * other file and no network: result, warnings, pictures, energies, tables, seconds.
 *
 * What the report does not tell, the page leaves out.
 * \param[in] report as the chain writes it into report.json
 * \param[in] picture_folder where the files of its "pictures" are */
std::string
reportPage(const nlohmann::ordered_json& report, const std::string& picture_folder);

/** \brief Writes \ref reportPage into a file.
 * \throws OutputFileException when it could not be written whole */
void
saveReportPage(const std::string& path,
               const nlohmann::ordered_json& report,
               const std::string& picture_folder);

} // namespace pcl::acmap
