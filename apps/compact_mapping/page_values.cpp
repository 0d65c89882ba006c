#include "page_values.h"

#include <cmath>

namespace pcl::acmap {

using Json = nlohmann::ordered_json;

namespace {

const Json nothing;

std::optional<double>
finiteNumber(const Json& json)
{
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    return {};
  return json.get<double>();
}

} // namespace

const Json&
fieldOf(const Json& json, std::string_view name)
{
  const auto found = json.find(name);
  return found == json.end() ? nothing : *found;
}

std::optional<double>
numberOf(const Json& json, const std::string& name)
{
  return finiteNumber(fieldOf(json, name));
}

std::string
textOf(const Json& json, const std::string& name)
{
  const Json& text = fieldOf(json, name);
  return text.is_string() ? text.get<std::string>() : std::string();
}

std::vector<std::string>
textsOf(const Json& json, const std::string& name)
{
  std::vector<std::string> texts;
  const Json& list = fieldOf(json, name);
  if (list.is_array())
    for (const Json& text : list)
      if (text.is_string())
        texts.push_back(text.get<std::string>());
  return texts;
}

const Json&
detailOf(const Json& report, std::string_view name)
{
  const Json& stages = fieldOf(report, "stages");
  if (stages.is_array())
    for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage) {
      const Json& field = fieldOf(fieldOf(*stage, "details"), name);
      if (!field.is_null())
        return field;
    }
  return nothing;
}

std::optional<double>
countOf(const Json& report, const std::string& name)
{
  const Json& field = detailOf(report, name);
  return field.is_array() ? static_cast<double>(field.size()) : finiteNumber(field);
}

} // namespace pcl::acmap
