#include "report/report_fields.h"

namespace pcl::acmap {

using Json = nlohmann::ordered_json;

namespace {

const Json no_field;

} // namespace

const Json&
fieldOf(const Json& json, std::string_view path)
{
  const std::size_t slash = path.find('/');
  const std::string name(path.substr(0, slash));
  const Json* field = &no_field;
  if (json.is_object() && json.contains(name))
    field = &json.at(name);
  else if (json.is_array() && name.size() == 1 && name[0] >= '0' &&
           static_cast<std::size_t>(name[0] - '0') < json.size())
    field = &json[static_cast<std::size_t>(name[0] - '0')];
  return slash == path.npos ? *field : fieldOf(*field, path.substr(slash + 1));
}

const Json&
listOf(const Json& json, std::string_view path)
{
  const Json& list = fieldOf(json, path);
  return list.is_array() ? list : no_field;
}

std::string
textOf(const Json& json, std::string_view path)
{
  const Json& text = fieldOf(json, path);
  return text.is_string() ? text.get<std::string>() : std::string();
}

} // namespace pcl::acmap
