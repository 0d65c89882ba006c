#include "layer_actors.h"

#include "vtk_pieces.h"

#include <pcl/visualization/layered_scene.h>

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkProperty.h>

#include <algorithm>
#include <optional>

namespace pcl {

namespace acmap {
namespace {

/** \brief The depth of the halves that were not divided further: most triangles have
 * it, and no wall does. */
std::optional<std::uint8_t>
deepestOf(const LargeVector<std::uint8_t>& depths)
{
  std::optional<std::uint8_t> deepest;
  for (const std::uint8_t depth : depths)
    if (depth != TriangleMesh::no_wall)
      deepest = std::max(depth, deepest.value_or(0));
  return deepest;
}

} // namespace
} // namespace acmap

std::size_t
wallSteps(const TriangleMesh& mesh)
{
  const auto deepest = acmap::deepestOf(mesh.wall_depth);
  // a mesh without walls needs no steps
  return deepest.value_or(0) == 0 ? 0 : *deepest + std::size_t{1};
}

namespace acmap {
namespace {

/** Neighbouring depths have clearly different colours; none resembles the grey of the
 * rest. */
constexpr std::array<ByteColor, 8> wall_colors = {{{214, 39, 40},
                                                   {31, 119, 180},
                                                   {44, 160, 44},
                                                   {255, 127, 14},
                                                   {148, 103, 189},
                                                   {23, 190, 207},
                                                   {227, 119, 194},
                                                   {140, 86, 75}}};
constexpr ByteColor rest_color = {200, 200, 204};
constexpr Color wall_point_color = {0.66, 0.68, 0.70};

/** Saturation of the colours of walls of earlier steps. */
constexpr double kept = 0.45;

/** \brief Was a triangle constructed up to a step? \param[in] steps of the whole
 * mesh */
bool
isMadeBy(std::uint8_t depth, std::size_t step, std::size_t steps)
{
  return depth <= step || step + 1 == steps;
}

ByteColor
colorOf(std::uint8_t depth, std::size_t step, std::size_t steps)
{
  if (depth + std::size_t{1} >= steps)
    return rest_color;
  ByteColor color = wall_colors[depth % wall_colors.size()];
  for (std::uint8_t& channel : color)
    if (depth != step)
      channel = static_cast<std::uint8_t>(kept * channel + (1 - kept) * 235);
  return color;
}

/** \brief The points of the mesh in a faint colour. */
vtkSmartPointer<vtkActor>
faintPoints(const Scene& scene)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf(scene.points));
  data->SetVerts(singlePoints(scene.points.size()));
  auto actor = actorOf(data, wall_point_color, false);
  actor->GetProperty()->SetPointSize(1);
  actor->GetProperty()->LightingOff();
  return actor;
}

/** \brief Filled triangles; for walls their edges, because walls are one triangle
 * wide. */
vtkSmartPointer<vtkActor>
actorOfPart(const Scene& scene,
            const TriangleMesh::Triangles& triangles,
            const std::vector<ByteColor>& colors,
            bool is_wall)
{
  constexpr float wall_pixels = 3;
  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf(scene.points));
  data->SetPolys(cellsOf(triangles));
  data->GetCellData()->SetScalars(colorsOf(colors));
  auto actor = actorOf(data, front_color, true);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.75);
  if (!is_wall)
    return actor;
  vtkNew<vtkPolyData> rims;
  rims->ShallowCopy(data);
  actor = linesOf(rims, front_color, true, wall_pixels);
  actor->GetProperty()->SetRepresentationToWireframe();
  return actor;
}

} // namespace

Actors
actorsOfWalls(const Scene& scene, std::size_t step, std::size_t steps, bool hide_backs)
{
  TriangleMesh::Triangles made, walls;
  std::vector<ByteColor> colors, wall_colors_made;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const std::uint8_t depth = scene.wall_depth[i];
    if (!isMadeBy(depth, step, steps))
      continue;
    made.push_back(scene.triangles[i]);
    colors.push_back(colorOf(depth, step, steps));
    if (depth + std::size_t{1} < steps) {
      walls.push_back(made.back());
      wall_colors_made.push_back(colors.back());
    }
  }
  Actors actors = {actorOfPart(scene, made, colors, false),
                   actorOfPart(scene, walls, wall_colors_made, true),
                   faintPoints(scene)};
  for (const auto& actor : actors)
    actor->GetProperty()->SetBackfaceCulling(hide_backs);
  return actors;
}

std::string
describeWalls(const TriangleMesh& mesh, std::size_t step)
{
  const std::size_t steps = wallSteps(mesh);
  std::size_t made = 0, fresh = 0;
  for (const std::uint8_t depth : mesh.wall_depth) {
    made += isMadeBy(depth, step, steps);
    fresh += depth == step && step + 1 < steps;
  }
  return "walls, step " + std::to_string(step) + " of 0 to " +
         std::to_string(steps - 1) + ": " + std::to_string(made) + " triangles of " +
         std::to_string(mesh.triangles.size()) + ", " + std::to_string(fresh) +
         " of walls of this depth\n";
}

} // namespace acmap
} // namespace pcl
