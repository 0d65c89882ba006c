#include <pcl/simulation/standard_scenes.h>

#include "scene_text.h"

#include <pcl/core/exceptions.h>

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
  std::string known;
  for (const acmap::StandardSceneText& scene : acmap::standardSceneTexts()) {
    if (name == scene.name)
      return acmap::readScene(acmap::parseYaml(name + ".yaml", scene.text));
    known += std::string(known.empty() ? "" : ", ") + scene.name;
  }
  throw acmap::BadArgument("'" + name + "' is no standard scene; there are " + known);
}

} // namespace pcl
