#include <pcl/simulation/scene_file.h>

#include "scene_text.h"

#include <pcl/core/file_format.h>
#include <pcl/core/impl/yaml_node.h>
#include <pcl/simulation/scene_geometry.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief Largest coordinate of a scene, metres. */
constexpr double farthest_place = 1e4;

/** \brief Runs an action that may reject a value; the error then names the line of the
 * node. */
template <typename Action>
void
atLineOf(const YamlNode& node, const Action& action)
{
  try {
    action();
  }
  catch (const BadArgumentException& exception) {
    // PCL puts ": " before every message
    const std::string fault = exception.what();
    node.fail(fault.substr(fault.find_first_not_of(": ")));
  }
}

/** \brief Reads a list of three numbers: a position or an edge, metres. */
Eigen::Vector3d
vectorOf(const YamlNode& node)
{
  const auto& items = node.list(3, 3);
  Eigen::Vector3d vector;
  for (int axis = 0; axis < 3; ++axis)
    vector[axis] =
        items[static_cast<std::size_t>(axis)].number(-farthest_place, farthest_place);
  return vector;
}

/** \brief Reads an angle of at most two full turns in degrees and returns radians. */
double
angleOf(const YamlNode& node)
{
  constexpr double max_degrees = 720.0;
  constexpr double degree = 3.14159265358979323846 / 180.0;
  return node.number(-max_degrees, max_degrees) * degree;
}

/** \brief The only key of a map, such as `box` in `- box: {...}`.
 * \throws InputFileException unless there is exactly one key */
const YamlNode&
onlyKeyOf(const YamlNode& node)
{
  if (node.keys().size() != 1)
    node.fail("one key is needed here, not " + std::to_string(node.keys().size()));
  return node.keys().front();
}

constexpr std::size_t max_items = 10000; // per list of the file

using Looks = std::map<std::string, SurfaceLook>;

SurfaceLook
readLook(const YamlNode& node)
{
  constexpr double strongest_texture = 255.0;
  constexpr std::size_t brightest = 255;
  node.requireKeys({"color", "texture"});
  SurfaceLook look;
  const auto& channels = node.at("color").list(3, 3);
  for (std::size_t i = 0; i < look.color.size(); ++i)
    look.color[i] = static_cast<std::uint8_t>(channels[i].count(0, brightest));
  look.texture = node.at("texture").number(0.0, strongest_texture);
  return look;
}

/** \brief Adds the surfaces of a file to a scene, in order. */
class SurfaceReader {
public:
  explicit SurfaceReader(Looks looks)
  : looks_(std::move(looks))
  {}

  void
  add(const YamlNode& item)
  {
    const YamlNode& key = onlyKeyOf(item);
    const YamlNode& surface = item.at(key.text());
    atLineOf(key, [&] {
      if (key.text() == "rectangle")
        addRectangle(surface);
      else if (key.text() == "box")
        addBox(surface);
      else if (key.text() == "cylinder")
        addCylinder(surface);
      else
        key.fail("'" + key.text() + "' is no surface; rectangle, box and cylinder are");
    });
  }

  SceneGeometry
  take()
  {
    return std::move(geometry_);
  }

private:
  const SurfaceLook&
  lookOf(const YamlNode& name) const
  {
    const auto look = looks_.find(name.text());
    if (look == looks_.end())
      name.fail("'" + name.text() + "' is none of the looks of this scene");
    return look->second;
  }

  void
  addRectangle(const YamlNode& node)
  {
    node.requireKeys({"name", "plane", "corner", "edges", "look", "openings"});
    const std::string& name = node.at("name").text();
    const YamlNode* const plane = node.find("plane");
    const std::string& plane_name = plane ? plane->text() : name;
    const auto& edges = node.at("edges").list(2, 2);
    const SimulatedRectangle rectangle{
        vectorOf(node.at("corner")), vectorOf(edges[0]), vectorOf(edges[1])};
    const SurfaceLook& look = lookOf(node.at("look"));
    if (const YamlNode* const openings = node.find("openings"))
      geometry_.addWall(name, plane_name, rectangle, look, readOpenings(*openings));
    else
      geometry_.addRectangle(name, plane_name, rectangle, look);
  }

  WallOpenings
  readOpenings(const YamlNode& node) const
  {
    node.requireKeys(
        {"name", "at", "width", "height", "depth", "panel", "reveal", "floor"});
    WallOpenings openings;
    openings.name = node.at("name").text();
    for (const YamlNode& at : node.at("at").list(1, max_items))
      openings.at.push_back(at.number(0.0, farthest_place));
    openings.width = node.at("width").number(0.0, farthest_place);
    openings.height = node.at("height").number(0.0, farthest_place);
    openings.depth = node.at("depth").number(0.0, farthest_place);
    openings.panel = lookOf(node.at("panel"));
    openings.reveal = lookOf(node.at("reveal"));
    openings.floor = node.at("floor").text();
    return openings;
  }

  static BoxFaces
  readFaces(const YamlNode& node)
  {
    constexpr std::size_t faces_of_a_box = 6;
    BoxFaces faces{false, false, false, false, false, false};
    const std::map<std::string, bool*> names = {{"left", &faces.left},
                                                {"right", &faces.right},
                                                {"top", &faces.top},
                                                {"bottom", &faces.bottom},
                                                {"front", &faces.front},
                                                {"back", &faces.back}};
    for (const YamlNode& name : node.list(1, faces_of_a_box)) {
      const auto face = names.find(name.text());
      if (face == names.end())
        name.fail("'" + name.text() +
                  "' is no face; left, right, top, bottom, front and back are");
      *face->second = true;
    }
    return faces;
  }

  void
  addBox(const YamlNode& node)
  {
    node.requireKeys({"name", "least", "most", "look", "faces"});
    const YamlNode* const faces = node.find("faces");
    geometry_.addBox(node.at("name").text(),
                     vectorOf(node.at("least")),
                     vectorOf(node.at("most")),
                     lookOf(node.at("look")),
                     faces ? readFaces(*faces) : BoxFaces{});
  }

  void
  addCylinder(const YamlNode& node)
  {
    node.requireKeys({"name", "base", "axis", "radius", "look", "caps"});
    const YamlNode* const caps = node.find("caps");
    const SimulatedCylinder cylinder{vectorOf(node.at("base")),
                                     vectorOf(node.at("axis")),
                                     node.at("radius").number(0.0, farthest_place)};
    geometry_.addCylinder(node.at("name").text(),
                          cylinder,
                          lookOf(node.at("look")),
                          caps && caps->boolean());
  }

  Looks looks_;
  SceneGeometry geometry_;
};

/** \brief Reads `looks` and `surfaces` of a scene. */
SceneGeometry
readSurfaces(const YamlNode& scene)
{
  Looks looks;
  const YamlNode& look_map = scene.at("looks");
  for (const YamlNode& name : look_map.keys())
    looks.emplace(name.text(), readLook(look_map.at(name.text())));
  SurfaceReader reader(std::move(looks));
  for (const YamlNode& item : scene.at("surfaces").list(1, max_items))
    reader.add(item);
  return reader.take();
}

constexpr std::size_t max_views = 100000;
constexpr std::size_t max_steps = 1000;

using Views = std::vector<Eigen::Isometry3d>;

/** \param[in] yaw about y, radians; positive turns z towards x */
Eigen::Isometry3d
poseOf(const Eigen::Vector3d& place, double yaw)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()));
  pose.translation() = place;
  return pose;
}

/** \brief Position of view \a i of \a count along its part of the path, in [0, 1]. */
double
fractionOf(std::size_t i, std::size_t count)
{
  return count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
}

void
addPose(const YamlNode& node, Views& views)
{
  node.requireKeys({"at", "yaw"});
  views.push_back(poseOf(vectorOf(node.at("at")), angleOf(node.at("yaw"))));
}

void
addLine(const YamlNode& node, Views& views)
{
  constexpr std::size_t max_yaws = 1000;
  constexpr double shortest = 1e-3; // metres
  node.requireKeys({"from", "to", "views", "yaw"});
  const Eigen::Vector3d from = vectorOf(node.at("from"));
  const Eigen::Vector3d way = vectorOf(node.at("to")) - from;
  if (std::hypot(way.x(), way.z()) < shortest)
    node.fail("the line has no direction; use turn or pose");
  const double heading = std::atan2(way.x(), way.z());
  std::vector<double> yaws;
  if (const YamlNode* const list = node.find("yaw"))
    for (const YamlNode& yaw : list->list(1, max_yaws))
      yaws.push_back(angleOf(yaw));
  else
    yaws.push_back(0.0);
  const std::size_t count = node.at("views").count(1, max_views);
  for (std::size_t i = 0; i < count; ++i)
    views.push_back(
        poseOf(from + fractionOf(i, count) * way, heading + yaws[i % yaws.size()]));
}

void
addTurn(const YamlNode& node, Views& views)
{
  node.requireKeys({"at", "from", "to", "views"});
  const Eigen::Vector3d place = vectorOf(node.at("at"));
  const double from = angleOf(node.at("from"));
  const double way = angleOf(node.at("to")) - from;
  const std::size_t count = node.at("views").count(1, max_views);
  for (std::size_t i = 0; i < count; ++i)
    views.push_back(poseOf(place, from + fractionOf(i, count) * way));
}

/** \brief Reads the `path` of a scene: T_scene_camera of each view. */
Views
readPath(const YamlNode& path)
{
  Views views;
  for (const YamlNode& item : path.list(1, max_steps)) {
    const YamlNode& key = onlyKeyOf(item);
    const YamlNode& step = item.at(key.text());
    if (key.text() == "pose")
      addPose(step, views);
    else if (key.text() == "line")
      addLine(step, views);
    else if (key.text() == "turn")
      addTurn(step, views);
    else
      key.fail("'" + key.text() + "' is no part of a path; pose, line and turn are");
    if (views.size() > max_views)
      key.fail("the path has more than " + std::to_string(max_views) + " views");
  }
  return views;
}

} // namespace

} // namespace pcl::acmap

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
