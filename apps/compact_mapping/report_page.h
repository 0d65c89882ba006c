#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The report of a run of the whole chain as an HTML page, which needs no other
 * file and no network: result, warnings, pictures, energies, tables, seconds.
 *
 * Values that are missing in the report are left out.
 * \param[in] report as the chain writes it into report.json
 * \param[in] picture_folder folder of the files in its "pictures" */
std::string
reportPage(const nlohmann::ordered_json& report, const std::string& picture_folder);

/** \brief Writes \ref reportPage into a file.
 * \throws OutputFileException when it could not be written completely */
void
saveReportPage(const std::string& path,
               const nlohmann::ordered_json& report,
               const std::string& picture_folder);

/** \brief The result in a paragraph; empty if nothing is known. */
std::string
resultParagraph(const nlohmann::ordered_json& report);

/** \brief The warnings of the run and of its stages, without duplicates; one line if
 * there are none. */
std::string
warningBox(const nlohmann::ordered_json& report);

/** \brief Base 64 with padding, on one line. */
std::string
base64(const std::vector<std::uint8_t>& bytes);

/** \brief A figure with an embedded PNG; if the file is missing or is no complete PNG,
 * the figure says so instead.
 * \param[in] path of the file
 * \param[in] name title of the picture
 * \param[in] caption may be empty */
std::string
pictureFigure(const std::string& path,
              const std::string& name,
              const std::string& caption);

/** \brief The energy over the steps of the rectification as SVG, with a legend, in the
 * style of \ref energyPicture; empty if there are no steps.
 * \param[in] steps columns "search", "bin_size" and "energy" */
std::string
energyFigure(const nlohmann::ordered_json& steps);

/** \brief Equation, area, deviation and support of each plane; empty without planes. */
std::string
planesTable(const nlohmann::ordered_json& report);

/** \brief The comparison with a known truth; empty if there is none. */
std::string
truthTable(const nlohmann::ordered_json& report);

/** \brief The summary of each stage; empty if there is none. */
std::string
summaryTables(const nlohmann::ordered_json& report);

/** \brief The style sheet of the report page, for screens, phones and print. */
const char*
pageStyle();

} // namespace pcl::acmap
