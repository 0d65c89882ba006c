#pragma once

#include <pcl/core/output_file.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>
#include <utility>

namespace pcl::acmap {

/** \brief Parses a text or a stream that anybody may have written.
 * \return a discarded value if it is no JSON, or nested deeper than our files are: copies are
 * made recursively */
template <typename Source>
nlohmann::ordered_json
parsedJson(Source&& source)
{
  using Json = nlohmann::ordered_json;
  constexpr int max_depth = 64;
  bool is_too_deep = false;
  Json json = Json::parse(
      std::forward<Source>(source),
      [&](int depth, Json::parse_event_t, const Json&) {
        is_too_deep = is_too_deep || depth > max_depth;
        return !is_too_deep;
      },
      false);
  return is_too_deep ? Json(Json::value_t::discarded) : json;
}

/** \brief The same for a file; a discarded value, too, if it cannot be read. */
inline nlohmann::ordered_json
readJson(const std::string& path)
{
  std::ifstream file(path);
  return parsedJson(file);
}

/** \brief A value as text, with replacements for invalid UTF-8.
 * \param[in] indent below 0: in one line */
inline std::string
jsonText(const nlohmann::ordered_json& json, int indent = -1)
{
  return json.dump(
      indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/** \brief Writes a value as such a text.
 * \throws OutputFileException when it could not be written completely */
inline void
saveJson(const std::string& path, const nlohmann::ordered_json& json, int indent)
{
  const std::string text = jsonText(json, indent) + "\n";
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

} // namespace pcl::acmap
