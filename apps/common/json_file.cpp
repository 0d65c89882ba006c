#include "json_file.h"

#include <fstream>

namespace pcl::acmap {

using Json = nlohmann::ordered_json;

Json
readJson(const std::string& path)
{
  constexpr int deepest = 64; // copies are made recursively
  bool is_too_deep = false;
  std::ifstream file(path);
  Json json = Json::parse(
      file,
      [&](int depth, Json::parse_event_t, const Json&) {
        is_too_deep = is_too_deep || depth > deepest;
        return !is_too_deep;
      },
      false);
  return is_too_deep ? Json(Json::value_t::discarded) : json;
}

bool
isPlainName(const std::string& name)
{
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string("/\0", 2)) == std::string::npos;
}

} // namespace pcl::acmap
