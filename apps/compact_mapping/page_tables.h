#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief Equation, area, deviation and support of each plane; empty without planes. */
std::string
planesTable(const nlohmann::ordered_json& report);

/** \brief The comparison with a known truth; empty if there is none. */
std::string
truthTable(const nlohmann::ordered_json& report);

/** \brief The summary of each stage; empty if there is none. */
std::string
summaryTables(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
