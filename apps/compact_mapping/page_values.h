#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::acmap {

/** \brief A field of an object; null if it is missing, or if the value is no object. */
const nlohmann::ordered_json&
fieldOf(const nlohmann::ordered_json& json, std::string_view name);

/** \brief A field that is a finite number; nothing if it is none. */
std::optional<double>
numberOf(const nlohmann::ordered_json& json, const std::string& name);

/** \brief A field that is a string; empty if it is none. */
std::string
textOf(const nlohmann::ordered_json& json, const std::string& name);

/** \brief The strings of a field that is a list. */
std::vector<std::string>
textsOf(const nlohmann::ordered_json& json, const std::string& name);

/** \brief A field of the details of the last stage that has it, otherwise null. */
const nlohmann::ordered_json&
detailOf(const nlohmann::ordered_json& report, std::string_view name);

/** \brief The value of such a field if it is a number, or the length if it is a
 * list. */
std::optional<double>
countOf(const nlohmann::ordered_json& report, const std::string& name);

} // namespace pcl::acmap
