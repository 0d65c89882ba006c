#include "primitive_tables.h"

#include "cpu_time.h"
#include "markdown_row.h"
#include "primitive_scenes.h"
#include "units.h"

#include <pcl/segmentation/box_fitting.h>
#include <pcl/simulation/standard_scenes.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl::acmap::bench {
namespace {

/** How a box was found. */
struct FoundBox {
  bool is_found = false;
  double size_error = 0;       ///< metres, largest
  double closed_error = 0;     ///< the same, between two sides that are planes
  std::size_t wrong_sides = 0; ///< seen where there is no face, or snapped to nothing
};

FoundBox
judge(const BoxPatch& box, const Eigen::Isometry3d& T_scene_map, const SceneBox& truth)
{
  constexpr double near = 0.1; // metres
  FoundBox found;
  const Eigen::Matrix3d axes = T_scene_map.linear() * box.axes;
  if ((T_scene_map * box.center - truth.place.center()).norm() > near)
    return found;
  found.is_found = true;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Eigen::Index along = 0;
    axes.col(axis).cwiseAbs().maxCoeff(&along);
    const double error = std::abs(box.size[axis] - truth.place.sizes()[along]);
    found.size_error = std::max(found.size_error, error);
    bool is_closed = true;
    for (std::size_t end = 0; end < 2; ++end) {
      const bool is_low = (axes(along, axis) < 0) != (end == 1);
      const bool has_face =
          truth.has_face[2 * static_cast<std::size_t>(along) + (is_low ? 1 : 0)];
      const BoxFaceKind kind = box.faces[2 * static_cast<std::size_t>(axis) + end].kind;
      is_closed = is_closed && kind != BoxFaceKind::Free;
      found.wrong_sides +=
          kind == (has_face ? BoxFaceKind::Snapped : BoxFaceKind::Seen);
    }
    if (is_closed)
      found.closed_error = std::max(found.closed_error, error);
  }
  return found;
}

/** What was found in a scene. */
struct SceneFinds {
  std::vector<PlanePatch> planes;
  std::vector<BoxPatch> boxes;
  std::vector<CylinderPatch> cylinders;
  double seconds = 0; ///< CPU time of the boxes
};

SceneFinds
findIn(const SimulatedScene& scene, bool searches_cylinders)
{
  MappedPlanes mapped = mapScene(scene, searches_cylinders);
  SceneFinds finds;
  finds.planes = std::move(mapped.planes);
  finds.cylinders = std::move(mapped.cylinders);
  BoxFitting fitting;
  fitting.setPlanes(finds.planes);
  const double begin = processSeconds();
  fitting.segment(finds.boxes);
  finds.seconds = processSeconds() - begin;
  return finds;
}

void
printBoxesRow(const std::string& name,
              const SimulatedScene& scene,
              const SceneFinds& finds,
              double reach)
{
  std::vector<SceneBox> truth = boxesOf(scene);
  truth.erase(std::remove_if(truth.begin(),
                             truth.end(),
                             [&](const SceneBox& box) {
                               return !isInSight(scene, box.place.center());
                             }),
              truth.end());
  std::size_t found = 0, wrong_sides = 0;
  double error = 0, closed_error = 0;
  for (const SceneBox& one : truth)
    for (const BoxPatch& box : finds.boxes)
      if (const FoundBox how = judge(box, scene.views.front(), one); how.is_found) {
        ++found;
        error = std::max(error, how.size_error);
        closed_error = std::max(closed_error, how.closed_error);
        wrong_sides += how.wrong_sides;
      }
  std::int32_t templates = 0;
  for (const BoxPatch& box : finds.boxes)
    templates = std::max(templates, box.template_id + 1);
  MarkdownRow()
      .text(name)
      .count(finds.planes.size())
      .atLeast(static_cast<double>(found), static_cast<double>(truth.size()), 0)
      .atMost(static_cast<double>(finds.boxes.size() - found), 0, 0)
      .atMost(milli * error, milli * reach, 1)
      .number(milli * closed_error, 1)
      .atMost(static_cast<double>(wrong_sides), 0, 0)
      .count(static_cast<std::size_t>(templates))
      .number(finds.seconds, 3)
      .print();
}

const CylinderPatch*
patchOf(const SimulatedCylinder& truth,
        const Eigen::Isometry3d& T_scene_map,
        const std::vector<CylinderPatch>& patches)
{
  constexpr double parallel = 0.99;  // 8 degrees
  constexpr double tolerance = 0.25; // of the radius
  const Eigen::Vector3d axis = truth.axis.normalized();
  for (const CylinderPatch& patch : patches) {
    const Eigen::Vector3d from = T_scene_map * patch.axis_point - truth.base;
    const Eigen::Vector3d direction = T_scene_map.linear() * patch.axis_direction;
    if (std::abs(axis.dot(direction)) > parallel &&
        std::abs(patch.radius - truth.radius) < tolerance * truth.radius &&
        (from - from.dot(axis) * axis).norm() < tolerance * truth.radius)
      return &patch;
  }
  return nullptr;
}

void
printCylinders(const SimulatedScene& scene, const std::vector<CylinderPatch>& patches)
{
  std::cout << "\n### Cylinders of the room\n";
  printHead({"cylinder", "radius mm", "found", "radius error mm", "length m"});
  std::size_t found = 0;
  for (const SimulatedSurface& surface : scene.geometry.surfaces()) {
    const auto* const truth = std::get_if<SimulatedCylinder>(&surface.shape);
    if (!truth)
      continue;
    constexpr double reach = 0.0003; // metres
    const CylinderPatch* const patch = patchOf(*truth, scene.views.front(), patches);
    found += patch ? 1 : 0;
    MarkdownRow row;
    row.text(surface.name)
        .number(milli * truth->radius, 0)
        .atLeast(patch ? 1 : 0, 1, 0);
    if (patch)
      row.atMost(milli * std::abs(patch->radius - truth->radius), milli * reach, 2)
          .number(patch->high - patch->low, 2);
    else
      row.text("–").text("–");
    row.print();
  }
  std::cout << "\nWrong cylinders: " << patches.size() - std::min(found, patches.size())
            << "\n";
}

} // namespace

void
printBoxes()
{
  std::cout << "\n### Boxes\n";
  printHead({"scene",
             "planes",
             "boxes found",
             "wrong",
             "largest size error mm",
             "between two planes mm",
             "wrong sides",
             "sizes",
             "CPU s"});
  const SimulatedScene room = standardScene("room");
  const SceneFinds finds = findIn(room, true);
  printBoxesRow("room", room, finds, 0.005);
  for (const char* const name : {"office",
                                 "corridor",
                                 "corridor_drive",
                                 "corridor_survey",
                                 "l_corridor",
                                 "loop"}) {
    const SimulatedScene scene = standardScene(name);
    printBoxesRow(name, scene, findIn(scene, false), 0.01);
  }
  for (const char* const name : {"office", "corridor_drive", "loop"}) {
    const SimulatedScene scene = withoutBoxes(standardScene(name));
    printBoxesRow(
        std::string(name) + " without boxes", scene, findIn(scene, false), 0.01);
  }
  printCylinders(room, finds.cylinders);
}

} // namespace pcl::acmap::bench
