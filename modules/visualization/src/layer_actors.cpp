#include "layer_actors.h"

#include "camera_fit.h"
#include "map_faces.h"
#include "map_lines.h"
#include "plan_lines.h"
#include "scene.h"
#include "scene_renderer.h"

#include <pcl/core/box_sides.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>

#include <algorithm>
#include <cmath>
#include <cstring>

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
  constexpr std::size_t maximum = 200000;
  const std::size_t step = points.size() / maximum + 1;
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
  const auto maximum = static_cast<float>(*level + headroom);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    if (points.points[i].dot(up.cast<float>()) > maximum)
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

Actors
proposedLayer(const LayerMaking& making)
{
  CompactMap map;
  map.planes = making.scene.map.planes;
  std::vector<MapLine> lines;
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane) {
    map.planes[plane].polygons = map.planes[plane].proposed;
    append(lines, outlinesOf(map, plane));
  }
  for (const BoxPatch& box : making.scene.map.boxes)
    for (PlanePatch& side : freeSidesOf(box)) {
      map.planes.push_back(std::move(side));
      append(lines, outlinesOf(map, map.planes.size() - 1));
    }
  Actors actors = actorsOfPlanes(facesOf(map), hidesBacks(making), layer_opacity);
  actors.push_back(actorOfOutlines(lines));
  return actors;
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
  case SceneLayer::Proposed:
    return proposedLayer(making);
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

namespace pcl {

namespace {

const PCLPointField*
viewField(const PCLPointCloud2& cloud)
{
  const PCLPointField* const field = acmap::findField(cloud, "view");
  return field && field->datatype == PCLPointField::INT32 ? field : nullptr;
}

/** \brief For each observation, the motion that undoes its rectification; NaN if a pose
 * is not finite. */
std::vector<Eigen::Isometry3f>
motionsOf(const Trajectory& after, const Trajectory& before)
{
  std::vector<Eigen::Isometry3f> motions;
  for (std::size_t i = 0; i < after.poses.size(); ++i)
    motions.push_back((before.poses[i] * after.poses[i].inverse()).cast<float>());
  return motions;
}

void
requireInside(const PCLPointField& field, const PCLPointCloud2& cloud)
{
  if (std::size_t{field.offset} + 4 > cloud.point_step ||
      cloud.data.size() < std::size_t{cloud.point_step} * cloud.width * cloud.height)
    throw acmap::BadArgument("field " + field.name + " is not inside of the cloud");
}

} // namespace

std::set<SceneLayer>
layersBefore(const LayeredScene& scene)
{
  std::set<SceneLayer> layers;
  const std::size_t poses = scene.trajectory_before.poses.size();
  if (poses == 0 || poses != scene.map.trajectory.poses.size())
    return layers;
  layers.insert(SceneLayer::Trajectory);
  if (scene.points.width != 0 && acmap::hasViews(scene.points))
    layers.insert(SceneLayer::Points);
  return layers;
}

namespace acmap {

bool
hasViews(const PCLPointCloud2& cloud)
{
  return viewField(cloud) != nullptr;
}

PCLPointCloud2
pointsBefore(const LayeredScene& scene)
{
  const PCLPointField* fields[4] = {};
  const char* const names[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields[axis] = findField(scene.points, names[axis]);
  fields[3] = viewField(scene.points);
  for (const PCLPointField* const field : fields) {
    if (!field)
      throw acmap::BadArgument("points without x y z and view have no place before");
    requireInside(*field, scene.points);
  }
  PCLPointCloud2 cloud = scene.points;
  const auto motions = motionsOf(scene.map.trajectory, scene.trajectory_before);
  const std::size_t size = std::size_t{cloud.width} * cloud.height;
  for (std::size_t i = 0; i < size; ++i) {
    std::uint8_t* const bytes = cloud.data.data() + i * cloud.point_step;
    std::int32_t view = 0;
    std::memcpy(&view, bytes + fields[3]->offset, sizeof view);
    Eigen::Vector3f point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(&point[axis], bytes + fields[axis]->offset, sizeof(float));
    if (view < 0 || static_cast<std::size_t>(view) >= motions.size())
      point.setConstant(NAN);
    else
      point = motions[static_cast<std::size_t>(view)] * point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::memcpy(bytes + fields[axis]->offset, &point[axis], sizeof(float));
  }
  return cloud;
}

} // namespace acmap

} // namespace pcl
