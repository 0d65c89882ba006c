#include "primitive_tables.h"

#include "cpu_time.h"
#include "markdown_row.h"
#include "primitive_scenes.h"
#include "units.h"

#include <pcl/segmentation/recess_fitting.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl::acmap::bench {
namespace {

/** A door of a scene, in the scene's frame. */
struct SceneDoor {
  std::string name;
  std::string panels; ///< name of the plane of its leaf
  std::string wall;   ///< name of the plane in which it is
  SimulatedRectangle opening;
  double depth = 0; ///< metres

  Eigen::Vector3d
  center() const
  {
    return opening.corner + (opening.edge_u + opening.edge_v) / 2;
  }

  Eigen::Vector3d
  size() const
  {
    return {opening.edge_u.norm(), opening.edge_v.norm(), depth};
  }
};

/** The plane of a wall less than half a metre before a leaf, and its distance. */
std::pair<std::string, double>
wallBefore(const SceneGeometry& geometry, const SimulatedRectangle& leaf)
{
  constexpr double reach = 0.5, exactly = 1e-6; // metres
  for (const TruthPlane& plane : geometry.planes()) {
    const Eigen::Vector3d normal = plane.coefficients.head<3>();
    const double depth = -normal.dot(leaf.corner) - plane.coefficients[3];
    if ((normal - leaf.normal()).norm() < exactly && depth > exactly && depth < reach)
      return {plane.name, depth};
  }
  return {"", 0};
}

/** The doors that openings of walls make: their heads are a plane "<name> heads". */
std::vector<SceneDoor>
doorsOf(const SimulatedScene& scene)
{
  std::vector<SceneDoor> doors;
  const std::vector<TruthPlane>& planes = scene.geometry.planes();
  for (const SimulatedSurface& surface : scene.geometry.surfaces()) {
    const auto* const leaf = std::get_if<SimulatedRectangle>(&surface.shape);
    if (!leaf)
      continue;
    const std::string panels = planes[static_cast<std::size_t>(surface.plane)].name;
    if (std::none_of(planes.begin(), planes.end(), [&](const TruthPlane& plane) {
          return plane.name == panels + " heads";
        }))
      continue;
    const auto [wall, depth] = wallBefore(scene.geometry, *leaf);
    SimulatedRectangle opening = *leaf;
    opening.corner += depth * leaf->normal();
    doors.push_back({surface.name, panels, wall, opening, depth});
  }
  return doors;
}

/** Is a surface part of a door? */
bool
isOfDoor(const std::string& name, const std::vector<SceneDoor>& doors)
{
  return std::any_of(doors.begin(), doors.end(), [&](const SceneDoor& door) {
    return name == door.name || name == door.name + " reveal" ||
           name == door.name + " floor";
  });
}

/** The same scene with walls instead of doors. */
SimulatedScene
withoutDoors(SimulatedScene scene)
{
  const std::vector<SceneDoor> doors = doorsOf(scene);
  SceneGeometry building;
  const std::vector<TruthPlane>& planes = scene.geometry.planes();
  for (const SimulatedSurface& surface : scene.geometry.surfaces()) {
    if (const auto* const cylinder = std::get_if<SimulatedCylinder>(&surface.shape))
      building.addCylinder(surface.name, *cylinder, surface.look, false);
    const auto* const shape = std::get_if<SimulatedRectangle>(&surface.shape);
    if (shape && !isOfDoor(surface.name, doors))
      building.addRectangle(surface.name,
                            planes[static_cast<std::size_t>(surface.plane)].name,
                            *shape,
                            surface.look);
  }
  for (const SceneDoor& door : doors)
    building.addRectangle(door.wall, door.wall, door.opening, SurfaceLook());
  scene.geometry = building;
  return scene;
}

/** How the doors of a scene were found. */
struct DoorFinds {
  std::size_t doors = 0; ///< in sight
  std::size_t found = 0;
  std::size_t on_floor = 0;                             ///< of those found
  std::size_t wrong = 0;                                ///< recesses that are no door
  Eigen::Vector3d size_error = Eigen::Vector3d::Zero(); ///< metres, largest
};

DoorFinds
judgeDoors(const SimulatedScene& scene, const std::vector<RecessPatch>& recesses)
{
  constexpr double near = 0.1; // metres
  DoorFinds finds;
  std::vector<bool> is_door(recesses.size(), false);
  for (const SceneDoor& door : doorsOf(scene)) {
    const bool counts = isInSight(scene, door.center());
    finds.doors += counts ? 1 : 0;
    for (std::size_t i = 0; i < recesses.size(); ++i) {
      const RecessPatch& recess = recesses[i];
      if ((scene.views.front() * recess.center - door.center()).norm() > near)
        continue;
      is_door[i] = true;
      finds.found += counts ? 1 : 0;
      finds.on_floor += counts && recess.reaches_floor ? 1 : 0;
      finds.size_error =
          finds.size_error.cwiseMax((recess.size - door.size()).cwiseAbs());
    }
  }
  finds.wrong =
      static_cast<std::size_t>(std::count(is_door.begin(), is_door.end(), false));
  return finds;
}

void
printDoorsRow(const std::string& name, const SimulatedScene& scene)
{
  constexpr double reach = 0.01; // metres
  const std::vector<PlanePatch> planes = mapScene(scene, false).planes;
  RecessFitting fitting;
  fitting.setPlanes(planes);
  std::vector<RecessPatch> recesses;
  const double begin = processSeconds();
  fitting.segment(recesses);
  const double seconds = processSeconds() - begin;
  const DoorFinds finds = judgeDoors(scene, recesses);
  MarkdownRow()
      .text(name)
      .count(planes.size())
      .atLeast(static_cast<double>(finds.found), static_cast<double>(finds.doors), 0)
      .atMost(static_cast<double>(finds.wrong), 0, 0)
      .count(finds.on_floor)
      .atMost(milli * finds.size_error.x(), milli * reach, 1)
      .atMost(milli * finds.size_error.y(), milli * reach, 1)
      .atMost(milli * finds.size_error.z(), milli * reach, 1)
      .count(fitting.getReport().templates)
      .number(fitting.getReport().bits_before, 0)
      .number(fitting.getReport().bits_after, 0)
      .number(seconds, 3)
      .print();
}

} // namespace

void
printDoors()
{
  std::cout << "\n### Doors\n";
  printHead({"scene",
             "planes",
             "doors found",
             "wrong",
             "on the floor",
             "width error mm",
             "height error mm",
             "depth error mm",
             "sizes",
             "bits before",
             "bits after",
             "CPU s"});
  for (const char* const name : {"corridor", "office", "l_corridor", "loop"}) {
    const SimulatedScene scene = standardScene(name);
    printDoorsRow(name, scene);
    printDoorsRow(std::string(name) + " without doors", withoutDoors(scene));
  }
}

} // namespace pcl::acmap::bench
