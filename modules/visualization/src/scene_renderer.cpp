#include "scene_renderer.h"

#include "vtk_pieces.h"

#include <vtkCamera.h>
#include <vtkMapper.h>
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
constexpr double boundary_pixels = 2.0;
constexpr double normal_pixels = 1.5;

vtkSmartPointer<vtkPolyData>
dataOf(const Scene& scene, const std::vector<ByteColor>& colors)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(scene.points));
  if (!colors.empty())
    data->GetPointData()->SetScalars(colorsOf(colors));
  return data;
}

} // namespace

vtkSmartPointer<vtkActor>
actorOfPoints(const Scene& scene, double pixels)
{
  const auto data = dataOf(scene, scene.colors);
  data->SetVerts(singlePoints(scene.points.size()));
  auto actor = actorOf(data, point_color, !scene.colors.empty());
  actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
  actor->GetProperty()->LightingOff();
  return actor;
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
    // pushed back behind what coincides with it, see pushBack
    side->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
    side->GetProperty()->SetInterpolationToFlat();
    side->GetProperty()->SetAmbient(scene.colors.empty() ? 0.12 : 0.35);
    side->GetProperty()->SetDiffuse(0.9);
  }
  Actors actors = {front};
  if (!hide_backs)
    actors.push_back(back);
  return actors;
}

void
pushBack(const Actors& actors, double metres, vtkCamera& camera)
{
  constexpr double unit = 1.6e-5; // of the depth, as VTK's shader has it
  double range[2];
  camera.GetClippingRange(range);
  const double distance = std::max(camera.GetDistance(), range[0]);
  const double slope =
      camera.GetParallelProjection()
          ? 1 / (range[1] - range[0])
          : range[1] * range[0] / (range[1] - range[0]) / (distance * distance);
  for (const auto& actor : actors)
    actor->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(
        0, metres * slope / unit);
}

void
showEdges(const Actors& mesh)
{
  for (const auto& side : mesh) {
    side->GetProperty()->EdgeVisibilityOn();
    side->GetProperty()->SetEdgeColor(edge_color.data());
  }
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

vtkSmartPointer<vtkAssembly>
assemblyOf(const Actors& actors)
{
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  for (const auto& actor : actors)
    assembly->AddPart(actor);
  return assembly;
}

} // namespace pcl::acmap
