#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::acmap {

/** \brief A field of an object; null where there is none, or no object. */
const nlohmann::ordered_json&
fieldOf(const nlohmann::ordered_json& json, std::string_view name);

/** \brief A field that is a finite number. */
std::optional<double>
numberOf(const nlohmann::ordered_json& json, const std::string& name);

/** \brief A field that is a text; an empty one where it is none. */
std::string
textOf(const nlohmann::ordered_json& json, const std::string& name);

/** \brief The texts of a field that is a list. */
std::vector<std::string>
textsOf(const nlohmann::ordered_json& json, const std::string& name);

/** \brief A field of the details of the last stage that has it, else null. */
const nlohmann::ordered_json&
detailOf(const nlohmann::ordered_json& report, std::string_view name);

/** \brief Of such a field: the number, or how many are in the list. */
std::optional<double>
countOf(const nlohmann::ordered_json& report, const std::string& name);

} // namespace pcl::acmap
