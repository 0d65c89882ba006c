#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief The result in a paragraph; empty if nothing is known. */
std::string
resultParagraph(const nlohmann::ordered_json& report);

/** \brief The warnings of the run and of its stages, without duplicates; one line if
 * there are none. */
std::string
warningBox(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
