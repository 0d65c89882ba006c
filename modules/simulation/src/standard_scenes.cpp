#include <pcl/simulation/standard_scenes.h>

#include "scene_text.h"

#include <pcl/core/exceptions.h>
#include <pcl/simulation/scene_file.h>

#include <algorithm>
#include <filesystem>

namespace pcl {

const std::vector<std::string>&
standardSceneNames()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const acmap::StandardSceneText& scene : acmap::standardSceneTexts())
      list.emplace_back(scene.name);
    return list;
  }();
  return names;
}

SimulatedScene
standardScene(const std::string& name)
{
  for (const acmap::StandardSceneText& scene : acmap::standardSceneTexts())
    if (name == scene.name)
      return acmap::readScene(acmap::parseYaml(name + ".yaml", scene.text));
  throw acmap::BadArgument("'" + name + "' is no standard scene; there are " +
                           acmap::listOfScenes());
}

SimulatedScene
openSimulatedScene(const std::string& name_or_path)
{
  const std::vector<std::string>& names = standardSceneNames();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end())
    return standardScene(name_or_path);
  std::error_code error;
  if (!std::filesystem::exists(name_or_path, error))
    throw InputFileException(name_or_path + ": is no file, and no standard scene (" +
                             acmap::listOfScenes() + ")");
  return loadSimulatedScene(name_or_path);
}

namespace acmap {

std::string
listOfScenes()
{
  std::string list;
  for (const std::string& name : standardSceneNames())
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

} // namespace acmap
} // namespace pcl
