#include "layer_stage.h"

#include "assembly.h"
#include "camera_fit.h"
#include "ray.h"
#include "scene_renderer.h"
#include "stage.h"

#include <pcl/exceptions.h>

#include <algorithm>

namespace pcl {

namespace {

bool
hasPoints(const PCLPointCloud2& cloud)
{
  return cloud.width != 0 && cloud.height != 0;
}

bool
hasColors(const TextureChart& chart)
{
  return !chart.colors.values.empty();
}

} // namespace

std::set<SceneLayer>
layersOf(const LayeredScene& scene)
{
  std::set<SceneLayer> layers;
  if (hasPoints(scene.points) || hasPoints(scene.vertices))
    layers.insert(SceneLayer::Points);
  if (!scene.mesh.triangles.empty())
    layers.insert({SceneLayer::Mesh, SceneLayer::Normals});
  if (!scene.map.planes.empty())
    layers.insert(SceneLayer::Planes);
  if (std::any_of(scene.map.charts.begin(), scene.map.charts.end(), hasColors))
    layers.insert(SceneLayer::Texture);
  if (!scene.map.trajectory.poses.empty())
    layers.insert(SceneLayer::Trajectory);
  return layers;
}

std::set<SceneLayer>
usualLayers(const LayeredScene& scene)
{
  const std::set<SceneLayer> all = layersOf(scene);
  std::set<SceneLayer> usual;
  for (const SceneLayer layer :
       {SceneLayer::Texture, SceneLayer::Planes, SceneLayer::Mesh, SceneLayer::Points})
    if (usual.empty() && all.count(layer) != 0)
      usual.insert(layer);
  if (all.count(SceneLayer::Planes) != 0 && all.count(SceneLayer::Trajectory) != 0)
    usual.insert(SceneLayer::Trajectory);
  return usual;
}

namespace acmap {

LayerStage::LayerStage(const LayeredScene& scene, const LayeredView& view)
: scene_(scene)
, view_(view)
{
  std::set<SceneLayer> all = layersOf(scene);
  all.erase(SceneLayer::Trajectory); // by itself it tells nothing of a place
  if (all.empty())
    throw InitFailedException("nothing to show: the scene has no points and no planes");
  if (!scene.map.planes.empty())
    drawing_.emplace(scene.map, view);
  else if (view.place != MapView::Place::Outside)
    throw BadArgumentException(
        "a view from inside and a plan need planes, and there are none");
  camera_ = drawing_ ? drawing_->camera() : cameraOfScene();
  const bool has_surface = drawing_ || all.count(SceneLayer::Mesh) != 0;
  renderer_ = makeStage(camera_, has_surface);
  for (const SceneLayer layer : view.layers.empty() ? usualLayers(scene) : view.layers)
    show(layer, true);
}

bool
LayerStage::isShown(SceneLayer layer) const
{
  const auto place = layers_.find(layer);
  return place != layers_.end() && place->second->GetVisibility();
}

void
LayerStage::show(SceneLayer layer, bool on)
{
  static const char* const names[] = {
      "points", "mesh", "normals", "planes", "texture", "trajectory"};
  if (layersOf(scene_).count(layer) == 0)
    throw BadArgumentException(std::string("there is nothing to show as ") +
                               names[static_cast<int>(layer) - 1]);
  auto& assembly = layers_[layer];
  if (!assembly) {
    assembly = assemblyOf(make(layer));
    renderer_->AddActor(assembly);
  }
  assembly->SetVisibility(on);
}

std::optional<std::size_t>
LayerStage::planeAt(double column, double row) const
{
  if (!drawing_)
    return {};
  const auto at = [&](double depth) -> Eigen::Vector3d {
    double point[4];
    renderer_->SetDisplayPoint(column, row, depth);
    renderer_->DisplayToWorld();
    renderer_->GetWorldPoint(point);
    return Eigen::Vector3d(point[0], point[1], point[2]) / point[3];
  };
  const Eigen::Vector3d eye = at(0);
  const auto hit =
      firstHit(drawing_->drawnFaces(), eye, at(1) - eye, drawing_->hidesBacks());
  if (!hit)
    return {};
  return hit->plane;
}

void
LayerStage::addPictureMarks()
{
  if (drawing_)
    drawing_->addPlanTo(renderer_);
}

Actors
LayerStage::make(SceneLayer layer) const
{
  constexpr double axis_share = 0.03; // of the way to the scene
  constexpr double least_axis = 0.1;  // metres
  switch (layer) {
  case SceneLayer::Points: {
    const Scene points = sceneOf(cloud(), {});
    const bool alone = layersOf(scene_).size() == 1;
    return {alone ? actorOfPoints(points, camera_) : actorOfPoints(points)};
  }
  case SceneLayer::Mesh: {
    const Scene mesh = sceneOf(scene_.vertices, scene_.mesh);
    Actors actors = actorsOfMesh(mesh, view_.hide_backs || hidesCeilings());
    if (view_.show_boundary)
      actors.push_back(actorOfBoundary(mesh));
    return actors;
  }
  case SceneLayer::Normals:
    return {actorOfNormals(sceneOf(scene_.vertices, scene_.mesh))};
  case SceneLayer::Planes: {
    Actors actors = drawing_->planes(layer_opacity);
    for (const auto& lines : drawing_->outlines())
      actors.push_back(lines);
    return actors;
  }
  case SceneLayer::Texture:
    return drawing_->textures();
  case SceneLayer::Trajectory:
    return actorsOfTrajectory(
        scene_.map.trajectory,
        std::max(least_axis, axis_share * (camera_.focus - camera_.position).norm()));
  }
  return {};
}

bool
LayerStage::hidesCeilings() const
{
  return drawing_ && drawing_->hidesBacks();
}

Scene
LayerStage::sceneOf(const PCLPointCloud2& cloud, const TriangleMesh& mesh) const
{
  Scene scene = makeScene(cloud, mesh);
  if (view_.ignore_colors)
    scene.colors.clear();
  return scene;
}

const PCLPointCloud2&
LayerStage::cloud() const
{
  return hasPoints(scene_.points) ? scene_.points : scene_.vertices;
}

Camera
LayerStage::cameraOfScene() const
{
  const Scene scene = scene_.mesh.triangles.empty()
                          ? makeScene(cloud(), {})
                          : makeScene(scene_.vertices, scene_.mesh);
  return placeCamera(scene.points, meanNormal(scene), view_);
}

} // namespace acmap
} // namespace pcl
