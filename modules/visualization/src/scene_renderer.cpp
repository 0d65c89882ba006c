#include "scene_renderer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace pcl::acmap {
namespace {

constexpr std::array<double, 3> front_color = {0.80, 0.80, 0.78};
constexpr std::array<double, 3> back_color = {0.55, 0.62, 0.78};
constexpr std::array<double, 3> boundary_color = {0.85, 0.20, 0.10};
constexpr std::array<double, 3> near_point_color = {1.00, 0.92, 0.75};
constexpr std::array<double, 3> far_point_color = {0.20, 0.33, 0.50};
constexpr double point_pixels = 3.0;
constexpr double boundary_pixels = 2.0;

vtkSmartPointer<vtkPoints>
pointsOf(const Scene& scene)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(static_cast<vtkIdType>(scene.points.size()));
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), scene.points[i].data());
  return points;
}

vtkSmartPointer<vtkUnsignedCharArray>
colorsOf(const std::vector<std::array<std::uint8_t, 3>>& values)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  for (const auto& color : values)
    colors->InsertNextTypedTuple(color.data());
  return colors;
}

/** \brief Colours that tell how far points are, which no light does on points. */
std::vector<std::array<std::uint8_t, 3>>
depthColors(const Scene& scene, const Camera& camera)
{
  const Eigen::Vector3d ahead = (camera.focus - camera.position).normalized();
  std::vector<std::array<std::uint8_t, 3>> colors;
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

/** \brief Cells with a fixed number of corners. */
template <typename Corners>
vtkSmartPointer<vtkCellArray>
cellsOf(const std::vector<Corners>& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->AllocateEstimate(static_cast<vtkIdType>(cells.size()),
                          std::tuple_size<Corners>::value);
  for (const Corners& corners : cells) {
    array->InsertNextCell(static_cast<int>(corners.size()));
    for (const std::int32_t corner : corners)
      array->InsertCellPoint(corner);
  }
  return array;
}

vtkSmartPointer<vtkCellArray>
singlePoints(std::size_t count)
{
  std::vector<std::array<std::int32_t, 1>> cells(count);
  for (std::size_t i = 0; i < count; ++i)
    cells[i] = {static_cast<std::int32_t>(i)};
  return cellsOf(cells);
}

vtkSmartPointer<vtkActor>
actorOf(vtkPolyData* data, const std::array<double, 3>& color, bool use_point_colors)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(use_point_colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

/** \brief Facets show the relief; the two sides are drawn apart, because a colour of the
 * points would cover the tint of the back. */
void
addMesh(const Scene& scene, vtkPolyData* data, bool hide_backs, vtkRenderer* renderer)
{
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
  renderer->AddActor(front);
  if (!hide_backs)
    renderer->AddActor(back);
}

void
addBoundary(const Scene& scene, vtkPoints* points, vtkRenderer* renderer)
{
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cellsOf(boundaryEdges(scene.triangles)));
  const auto lines = actorOf(data, boundary_color, false);
  lines->GetProperty()->SetLineWidth(boundary_pixels);
  lines->GetProperty()->LightingOff();
  // lines lie in the facets they bound; without this they would flicker through them
  lines->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
  lines->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -4);
  renderer->AddActor(lines);
}

void
addPoints(const Scene& scene,
          const Camera& camera,
          vtkPolyData* data,
          vtkRenderer* renderer)
{
  data->SetVerts(singlePoints(scene.points.size()));
  if (scene.colors.empty())
    data->GetPointData()->SetScalars(colorsOf(depthColors(scene, camera)));
  const auto actor = actorOf(data, near_point_color, true);
  actor->GetProperty()->SetPointSize(point_pixels);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

/** \brief Light behind surfaces, dark behind points, which would drown in light. */
void
setBackground(bool light, vtkRenderer* renderer)
{
  if (light) {
    renderer->SetBackground(0.97, 0.97, 0.96);
    renderer->SetBackground2(0.80, 0.84, 0.89);
  }
  else {
    renderer->SetBackground(0.10, 0.11, 0.13);
    renderer->SetBackground2(0.20, 0.23, 0.27);
  }
  renderer->GradientBackgroundOn();
}

/** \brief A key light from above the eye's left shoulder, a weak one from the eye. */
void
addLights(vtkRenderer* renderer)
{
  struct Lamp {
    double x, y, z, intensity;
  };
  for (const Lamp& lamp : {Lamp{-0.7, 0.9, 1.0, 0.75}, Lamp{0.3, 0.0, 1.0, 0.35}}) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(lamp.x, lamp.y, lamp.z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(lamp.intensity);
    renderer->AddLight(light);
  }
}

void
setCamera(const Camera& camera, vtkRenderer* renderer)
{
  vtkCamera* const active = renderer->GetActiveCamera();
  active->SetPosition(camera.position.data());
  active->SetFocalPoint(camera.focus.data());
  active->SetViewUp(camera.up.data());
  active->SetViewAngle(camera.view_angle);
  active->SetClippingRange(camera.near, camera.far);
}

} // namespace

vtkSmartPointer<vtkRenderer>
makeRenderer(const Scene& scene, const Camera& camera, const SceneView& view)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();

  const auto points = pointsOf(scene);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  if (!scene.colors.empty())
    data->GetPointData()->SetScalars(colorsOf(scene.colors));
  if (scene.isMesh())
    addMesh(scene, data, view.hide_backs, renderer);
  else
    addPoints(scene, camera, data, renderer);
  if (view.show_boundary && scene.isMesh())
    addBoundary(scene, points, renderer);
  setBackground(scene.isMesh(), renderer);
  addLights(renderer);
  setCamera(camera, renderer);
  return renderer;
}

} // namespace pcl::acmap
