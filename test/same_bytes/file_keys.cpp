#include "file_keys.h"

#include "json_file.h"
#include "temporary_folder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

using KeySets = std::map<std::string, std::set<std::string>>;

void
collectKeys(const std::string& place, const nlohmann::json& value, KeySets& keys)
{
  if (value.is_object())
    for (const auto& [key, one] : value.items()) {
      keys[place].insert(key);
      collectKeys(place + "/" + key, one, keys);
    }
  else if (value.is_array())
    for (const auto& one : value)
      collectKeys(place + "/#", one, keys);
}

} // namespace

std::map<std::string, std::string>
keysIn(const std::string& folder)
{
  KeySets keys;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != "report.json" && name != "map.json" && name != "stage.json")
      continue;
    auto content = jsonOfFile(entry.path().string());
    if (name == "stage.json")
      content = content.at("made_of");
    collectKeys(fs::relative(entry.path(), folder).string() + " ", content, keys);
  }
  std::map<std::string, std::string> lists;
  for (const auto& [place, names] : keys)
    for (const std::string& name : names)
      lists[place] += (lists[place].empty() ? "" : ", ") + name;
  return lists;
}

} // namespace pcl::acmap::test
