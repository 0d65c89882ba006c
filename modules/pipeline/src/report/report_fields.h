#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace pcl::acmap {

/** \brief A field of a report that may be of another version, or damaged.
 * \param[in] path of a field in objects and lists, such as "truth/compactness"
 * \return null if there is no such field */
const nlohmann::ordered_json&
fieldOf(const nlohmann::ordered_json& json, std::string_view path);

/** \brief A field that is a list, otherwise null. */
const nlohmann::ordered_json&
listOf(const nlohmann::ordered_json& json, std::string_view path);

/** \brief A field that is a text, otherwise an empty one. */
std::string
textOf(const nlohmann::ordered_json& json, std::string_view path);

} // namespace pcl::acmap
