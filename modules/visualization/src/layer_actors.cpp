#include "layer_actors.h"

#include "assembly.h"
#include "camera_fit.h"
#include "plan_lines.h"
#include "points_before.h"
#include "wall_actors.h"

#include <algorithm>

namespace pcl::acmap {
namespace {

Scene
sceneOf(const PCLPointCloud2& cloud, const TriangleMesh& mesh, const SceneView& view)
{
  Scene scene = makeScene(cloud, mesh);
  if (view.ignore_colors)
    scene.colors.clear();
  return scene;
}

/** \brief Subsamples many points; enough to place a camera. */
std::vector<Eigen::Vector3f>
someOf(const std::vector<Eigen::Vector3f>& points)
{
  constexpr std::size_t most = 200000;
  const std::size_t step = points.size() / most + 1;
  std::vector<Eigen::Vector3f> some;
  for (std::size_t i = 0; i < points.size(); i += step)
    some.push_back(points[i]);
  return some;
}

MapFrame
directionsOf(const LayerMaking& making, const Scene& points)
{
  return making.drawing ? making.drawing->frame()
                        : frameOf(making.scene.map, someOf(points.points), making.view);
}

/** \brief Removes points above the cameras, which would hide the rest of a plan. */
void
cutForPlan(const LayerMaking& making, const Trajectory& trajectory, Scene& points)
{
  constexpr double headroom = 0.3; // metres above the cameras
  if (making.view.place != MapView::Place::Plan)
    return;
  const Eigen::Vector3d up = directionsOf(making, points).up;
  const auto level = eyeLevel(trajectory, up);
  if (!level)
    return;
  const auto most = static_cast<float>(*level + headroom);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    if (points.points[i].dot(up.cast<float>()) > most)
      continue;
    points.points[kept] = points.points[i];
    if (!points.colors.empty())
      points.colors[kept] = points.colors[i];
    ++kept;
  }
  points.points.resize(kept);
  points.colors.resize(points.colors.empty() ? 0 : kept);
}

Actors
pointLayer(const LayerMaking& making,
           const PCLPointCloud2& cloud,
           const Trajectory& trajectory)
{
  Scene points = sceneOf(cloud, {}, making.view);
  cutForPlan(making, trajectory, points);
  const bool alone = !making.drawing && making.scene.mesh.triangles.empty();
  return {alone ? actorOfPoints(points, making.camera) : actorOfPoints(points)};
}

Actors
wayOf(const LayerMaking& making, const Trajectory& trajectory)
{
  constexpr double axis_share = 0.03; // of the distance to the focus
  constexpr double min_axis = 0.1;    // metres
  const Camera& camera = making.camera;
  return actorsOfTrajectory(
      trajectory,
      std::max(min_axis, axis_share * (camera.focus - camera.position).norm()));
}

bool
hidesBacks(const LayerMaking& making)
{
  return making.view.hide_backs || (making.drawing && making.drawing->hidesBacks());
}

} // namespace

const PCLPointCloud2&
cloudOf(const LayeredScene& scene)
{
  const bool has_points = scene.points.width != 0 && scene.points.height != 0;
  return has_points ? scene.points : scene.vertices;
}

Camera
cameraOf(const LayeredScene& scene, const LayeredView& view)
{
  const bool is_cloud = scene.mesh.triangles.empty();
  const Scene all =
      is_cloud ? makeScene(cloudOf(scene), {}) : makeScene(scene.vertices, scene.mesh);
  if (scene.map.trajectory.poses.empty())
    return placeCamera(all.points, meanNormal(all), view);
  const auto samples = someOf(all.points);
  return placeMapCamera(
      scene.map, {}, samples, frameOf(scene.map, samples, view), view);
}

Actors
actorsOfLayer(const LayerMaking& making, SceneLayer layer)
{
  const LayeredScene& scene = making.scene;
  switch (layer) {
  case SceneLayer::Points:
    return pointLayer(making, cloudOf(scene), scene.map.trajectory);
  case SceneLayer::Mesh: {
    const Scene mesh = sceneOf(scene.vertices, scene.mesh, making.view);
    Actors actors = actorsOfMesh(mesh, hidesBacks(making));
    if (making.view.show_boundary)
      actors.push_back(actorOfBoundary(mesh));
    return actors;
  }
  case SceneLayer::Normals:
    return {actorOfNormals(sceneOf(scene.vertices, scene.mesh, making.view))};
  case SceneLayer::Planes: {
    Actors actors = making.drawing->planes(layer_opacity);
    for (const auto& lines : making.drawing->outlines())
      actors.push_back(lines);
    return actors;
  }
  case SceneLayer::Texture:
    return making.drawing->textures();
  case SceneLayer::Trajectory:
    return wayOf(making, scene.map.trajectory);
  }
  return {};
}

Actors
actorsBefore(const LayerMaking& making, SceneLayer layer)
{
  const Trajectory& trajectory = making.scene.trajectory_before;
  if (layer == SceneLayer::Points)
    return pointLayer(making, pointsBefore(making.scene), trajectory);
  return wayOf(making, trajectory);
}

Actors
actorsOfStep(const LayerMaking& making, std::size_t step)
{
  const LayeredScene& scene = making.scene;
  return actorsOfWalls(makeScene(scene.vertices, scene.mesh),
                       step,
                       wallSteps(scene.mesh),
                       hidesBacks(making));
}

} // namespace pcl::acmap
