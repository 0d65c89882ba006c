#include "scene_renderer.h"

#include "picture.h"
#include "vtk_pieces.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr Color boundary_color = {0.85, 0.20, 0.10};
constexpr Color edge_color = {0.33, 0.40, 0.52};
constexpr Color normal_color = {0.10, 0.55, 0.25};
constexpr Color point_color = {0.20, 0.40, 0.70};
constexpr Color near_point_color = {1.00, 0.92, 0.75};
constexpr Color far_point_color = {0.20, 0.33, 0.50};
constexpr double point_pixels = 3.0;
constexpr double boundary_pixels = 2.0;
constexpr double normal_pixels = 1.5;

/** \brief Colours that encode the depth of points, which have no lighting. */
std::vector<ByteColor>
depthColors(const Scene& scene, const Camera& camera)
{
  const Eigen::Vector3d ahead = (camera.focus - camera.position).normalized();
  std::vector<ByteColor> colors;
  for (const Eigen::Vector3f& point : scene.points) {
    const double depth = (point.cast<double>() - camera.position).dot(ahead);
    const double t =
        std::clamp((depth - camera.near) / (camera.far - camera.near), 0.0, 1.0);
    auto& color = colors.emplace_back();
    for (std::size_t c = 0; c < 3; ++c)
      color[c] = static_cast<std::uint8_t>(
          255 * (near_point_color[c] * (1 - t) + far_point_color[c] * t));
  }
  return colors;
}

vtkSmartPointer<vtkPolyData>
dataOf(const Scene& scene, const std::vector<ByteColor>& colors)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(scene.points));
  if (!colors.empty())
    data->GetPointData()->SetScalars(colorsOf(colors));
  return data;
}

void
showEdges(vtkActor& mesh)
{
  mesh.GetProperty()->EdgeVisibilityOn();
  mesh.GetProperty()->SetEdgeColor(edge_color.data());
}

vtkSmartPointer<vtkActor>
coloredPoints(const Scene& scene, const std::vector<ByteColor>& colors)
{
  const auto data = dataOf(scene, colors);
  data->SetVerts(singlePoints(scene.points.size()));
  auto actor = actorOf(data, point_color, !colors.empty());
  actor->GetProperty()->SetPointSize(point_pixels);
  actor->GetProperty()->LightingOff();
  return actor;
}

} // namespace

vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene)
{
  return coloredPoints(scene, scene.colors);
}

vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene, const Camera& camera)
{
  return coloredPoints(
      scene, scene.colors.empty() ? depthColors(scene, camera) : scene.colors);
}

Actors
actorsOfMesh(const Scene& scene, bool hide_backs)
{
  const auto data = dataOf(scene, scene.colors);
  data->SetPolys(cellsOf(scene.triangles));
  const auto front = actorOf(data, front_color, !scene.colors.empty());
  front->GetProperty()->BackfaceCullingOn();
  const auto back = actorOf(data, back_color, false);
  back->GetProperty()->FrontfaceCullingOn();
  for (const auto& side : {front, back}) {
    side->GetProperty()->SetInterpolationToFlat();
    side->GetProperty()->SetAmbient(scene.colors.empty() ? 0.12 : 0.35);
    side->GetProperty()->SetDiffuse(0.9);
  }
  Actors actors = {front};
  if (!hide_backs)
    actors.push_back(back);
  return actors;
}

vtkSmartPointer<vtkActor>
actorOfBoundary(const Scene& scene)
{
  const auto data = dataOf(scene, {});
  data->SetLines(cellsOf(boundaryEdges(scene.triangles)));
  return linesOf(data, boundary_color, false, boundary_pixels);
}

vtkSmartPointer<vtkActor>
actorOfNormals(const Scene& scene)
{
  std::vector<Eigen::Vector3f> ends;
  std::vector<std::array<std::int32_t, 2>> pairs;
  for (const auto& [foot, tip] : normalLines(scene)) {
    const auto first = static_cast<std::int32_t>(ends.size());
    ends.push_back(foot);
    ends.push_back(tip);
    pairs.push_back({first, first + 1});
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(pointsOf(ends));
  data->SetLines(cellsOf(pairs));
  return linesOf(data, normal_color, false, normal_pixels);
}

vtkSmartPointer<vtkRenderer>
makeRenderer(const Scene& scene, const Camera& camera, const SceneView& view)
{
  auto renderer = makeStage(camera, scene.isMesh());
  if (!scene.isMesh()) {
    renderer->AddActor(actorOfPoints(scene, camera));
    return renderer;
  }
  for (const auto& actor : actorsOfMesh(scene, view.hide_backs)) {
    if (view.show_edges)
      showEdges(*actor);
    renderer->AddActor(actor);
  }
  if (view.show_boundary)
    renderer->AddActor(actorOfBoundary(scene));
  return renderer;
}

vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors)
{
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  for (const auto& actor : actors)
    assembly->AddPart(actor);
  return assembly;
}

} // namespace pcl::acmap
