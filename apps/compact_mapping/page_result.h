#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief What came out, in a paragraph; empty where nothing is known. */
std::string
resultParagraph(const nlohmann::ordered_json& report);

/** \brief The warnings of the run and of its stages, each once; a line where there are
 * none. */
std::string
warningBox(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
