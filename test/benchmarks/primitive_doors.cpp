#include "bench.h"
#include "primitive_scenes.h"

#include <pcl/segmentation/recess_fitting.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Geometry>

#include <utility>
#include <variant>

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

/** The same scene with walls instead of doors. */
SimulatedScene
withoutDoors(const SimulatedScene& scene)
{
  const std::vector<SceneDoor> doors = doorsOf(scene);
  const auto isOfDoor = [&](const std::string& name) {
    return std::any_of(doors.begin(), doors.end(), [&](const SceneDoor& door) {
      return name == door.name || name == door.name + " reveal" ||
             name == door.name + " floor";
    });
  };
  SimulatedScene closed = withoutSurfaces(scene, isOfDoor, true);
  for (const SceneDoor& door : doors)
    closed.geometry.addRectangle(door.wall, door.wall, door.opening, SurfaceLook());
  return closed;
}

void
printDoors(const std::string& name, const SimulatedScene& scene)
{
  constexpr double near = 0.1, reach = 0.01; // metres
  const std::vector<PlanePatch> planes = mapScene(scene, false).planes;
  RecessFitting fitting;
  fitting.setPlanes(planes);
  std::vector<RecessPatch> recesses;
  const double seconds = measureCost([&] { fitting.segment(recesses); }).cpu;
  std::size_t doors = 0, found = 0, on_floor = 0; // those in sight
  Eigen::Vector3d size_error = Eigen::Vector3d::Zero();
  std::vector<bool> is_door(recesses.size(), false);
  for (const SceneDoor& door : doorsOf(scene)) {
    const bool counts = isInSight(scene, door.center());
    doors += counts ? 1 : 0;
    for (std::size_t i = 0; i < recesses.size(); ++i) {
      const RecessPatch& recess = recesses[i];
      if ((scene.views.front() * recess.center - door.center()).norm() > near)
        continue;
      is_door[i] = true;
      found += counts ? 1 : 0;
      on_floor += counts && recess.reaches_floor ? 1 : 0;
      size_error = size_error.cwiseMax((recess.size - door.size()).cwiseAbs());
    }
  }
  const RecessFittingReport& report = fitting.getReport();
  Row() << name << planes.size() << atLeast(found, doors, 0)
        << atMost(std::count(is_door.begin(), is_door.end(), false), 0, 0) << on_floor
        << atMost(milli * size_error.x(), milli * reach, 1)
        << atMost(milli * size_error.y(), milli * reach, 1)
        << atMost(milli * size_error.z(), milli * reach, 1) << report.templates
        << figure(report.bits_before, 0) << figure(report.bits_after, 0)
        << figure(seconds, 3);
}

const Section doors_section("doors", [] {
  printHead(
      "scene | planes | doors found | wrong | on the floor | width error mm | height "
      "error mm | depth error mm | sizes | bits before | bits after | CPU s");
  for (const std::string name : {"corridor", "office", "l_corridor", "loop"}) {
    const SimulatedScene scene = standardScene(name);
    printDoors(name, scene);
    printDoors(name + " without doors", withoutDoors(scene));
  }
});

} // namespace
} // namespace pcl::acmap::bench
