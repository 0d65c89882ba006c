#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl::acmap {

/** \brief Equation, area, deviation and support of each plane; empty without planes. */
std::string
planesTable(const nlohmann::ordered_json& report);

/** \brief The figures against a known truth; empty where there is none. */
std::string
truthTable(const nlohmann::ordered_json& report);

/** \brief What each stage told; empty where none told anything. */
std::string
summaryTables(const nlohmann::ordered_json& report);

} // namespace pcl::acmap
