#include <pcl/simulation/scene_file.h>

#include "path_reader.h"
#include "scene_text.h"
#include "surface_reader.h"
#include "yaml_values.h"

#include <pcl/core/file_format.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>

namespace pcl {

namespace {

constexpr std::size_t max_pixels = std::size_t{1} << 30;

RangeSensor
readSensor(const acmap::YamlNode& node, std::size_t views)
{
  node.requireKeys({"reach", "points", "total_points"});
  RangeSensor sensor;
  constexpr double min_reach = 1e-2;
  if (const auto* const reach = node.find("reach"))
    sensor.reach = reach->number(min_reach, acmap::farthest_place);
  const auto* const points = node.find("points");
  const auto* const total = node.find("total_points");
  if (points && total)
    total->fail("points of a view are given too: one of both is enough");
  if (points)
    sensor.points = points->count(1, max_pixels);
  if (total) {
    const std::size_t all = total->count(views, views * max_pixels);
    sensor.points = all / views;
    sensor.views_with_one_more = all % views;
  }
  return sensor;
}

/** Reads the surfaces of the document, or copies those of a standard scene. */
SceneGeometry
readBuilding(const acmap::YamlNode& document)
{
  const auto* const building = document.find("building");
  if (!building)
    return acmap::readSurfaces(document);
  for (const char* const own : {"looks", "surfaces"})
    if (const auto* const node = document.find(own))
      node->fail("the building is that of another scene, which has its own");
  const std::string& name = building->text();
  const auto& known = standardSceneNames();
  if (std::find(known.begin(), known.end(), name) == known.end())
    building->fail("'" + name + "' is no standard scene");
  return standardScene(name).geometry;
}

} // namespace

namespace acmap {

SimulatedScene
readScene(const YamlNode& document)
{
  requireFormat(document, file_formats::scene);
  document.requireKeys(
      {"format", "name", "rig", "sensor", "building", "looks", "surfaces", "path"});
  SimulatedScene scene;
  scene.name = document.at("name").text();
  if (const YamlNode* const rig = document.find("rig"))
    scene.rig = readTrinocularRig(*rig);
  scene.geometry = readBuilding(document);
  scene.views = readPath(document.at("path"));
  if (const YamlNode* const sensor = document.find("sensor"))
    scene.sensor = readSensor(*sensor, scene.views.size());
  return scene;
}

} // namespace acmap

SimulatedScene
loadSimulatedScene(const std::string& path)
{
  return acmap::readScene(acmap::loadYaml(path));
}

} // namespace pcl
