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

/** \brief Number of squares of a picture in which there are points.
 * \param[in] pixels of the points, from 0 to the size of the picture
 * \param[in] side of a square, pixels */
std::size_t
squaresWithPoints(const std::vector<Eigen::Vector2f>& pixels,
                  const SceneView& view,
                  float side)
{
  const auto columns =
      static_cast<std::size_t>(static_cast<float>(view.width) / side) + 1;
  const auto rows =
      static_cast<std::size_t>(static_cast<float>(view.height) / side) + 1;
  std::vector<bool> squares(columns * rows);
  for (const Eigen::Vector2f& pixel : pixels)
    squares[static_cast<std::size_t>(pixel.y() / side) * columns +
            static_cast<std::size_t>(pixel.x() / side)] = true;
  return static_cast<std::size_t>(std::count(squares.begin(), squares.end(), true));
}

/** \brief The size at which points close up to surfaces in the first picture, pixels. */
double
pointSize(const std::vector<Eigen::Vector3f>& points,
          const Camera& camera,
          const SceneView& view)
{
  constexpr float least = 2, most = 7;
  constexpr double closed = 0.88; // of the squares twice as large
  const Eigen::Vector3d ahead = (camera.focus - camera.position).normalized();
  const Eigen::Vector3d right = ahead.cross(camera.up);
  const double slope = std::tan(camera.view_angle / 2 * degree);
  std::vector<Eigen::Vector2f> pixels;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d d = point.cast<double>() - camera.position;
    const double half_height =
        camera.parallel_height > 0 ? camera.parallel_height / 2 : slope * d.dot(ahead);
    const Eigen::Vector2d place = Eigen::Vector2d(d.dot(right), d.dot(camera.up)) *
                                      (view.height / 2.0 / half_height) +
                                  Eigen::Vector2d(view.width, view.height) / 2;
    if (half_height > 0 && place.minCoeff() >= 0 && place.x() < view.width &&
        place.y() < view.height)
      pixels.push_back(place.cast<float>());
  }
  float size = least;
  while (size < most &&
         4.0 * static_cast<double>(squaresWithPoints(pixels, view, 2 * size)) * closed >
             static_cast<double>(squaresWithPoints(pixels, view, size)))
    ++size;
  return size + 1; // else holes of a pixel remain, with their dark rims
}

Actors
pointLayer(const LayerMaking& making,
           const PCLPointCloud2& cloud,
           const Trajectory& trajectory)
{
  Scene points = sceneOf(cloud, {}, making.view);
  cutForPlan(making, trajectory, points);
  return {actorOfPoints(points, pointSize(points.points, making.camera, making.view))};
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

/** \brief The proposed surfaces as planes of a map. */
CompactMap
proposedMap(const CompactMap& map)
{
  CompactMap proposed;
  proposed.planes = map.planes;
  for (PlanePatch& plane : proposed.planes)
    plane.polygons = plane.proposed;
  for (const BoxPatch& box : map.boxes)
    for (PlanePatch& side : freeSidesOf(box))
      proposed.planes.push_back(std::move(side));
  return proposed;
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
  auto samples = someOf(all.points);
  addPlaces(scene.map.trajectory, samples);
  return placeMapCamera(
      scene.map, {}, samples, frameOf(scene.map, samples, view), view);
}

std::vector<Eigen::Vector3f>
pointsToSee(const LayeredScene& scene, const LayeredView& view)
{
  std::vector<Eigen::Vector3f> points;
  const auto see = [&](const PCLPointCloud2& cloud, const TriangleMesh& mesh) {
    const auto more = someOf(makeScene(cloud, mesh).points);
    points.insert(points.end(), more.begin(), more.end());
  };
  const std::set<SceneLayer> all = layersOf(scene);
  const auto shows = [&](SceneLayer layer) {
    return view.layers.count(layer) != 0 && all.count(layer) != 0;
  };
  if (shows(SceneLayer::Points))
    see(cloudOf(scene), {});
  if (shows(SceneLayer::Mesh))
    see(scene.vertices, scene.mesh);
  return points;
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
    if (making.view.show_edges)
      showEdges(actors);
    if (making.view.show_boundary)
      actors.push_back(actorOfBoundary(mesh));
    return actors;
  }
  case SceneLayer::Normals:
    return {actorOfNormals(sceneOf(scene.vertices, scene.mesh, making.view))};
  case SceneLayer::Planes:
    return making.drawing->planes(layer_opacity);
  case SceneLayer::Texture:
    return making.drawing->textures();
  case SceneLayer::Trajectory:
    return wayOf(making, scene.map.trajectory);
  case SceneLayer::Proposed:
    return actorsOfPlanes(
        facesOf(proposedMap(scene.map)), hidesBacks(making), layer_opacity);
  }
  return {};
}

std::vector<SurfaceOutline>
outlinesOfLayer(const LayerMaking& making, SceneLayer layer)
{
  if (layer == SceneLayer::Planes)
    return making.drawing->outlinesApart();
  std::vector<SurfaceOutline> outlines;
  if (layer != SceneLayer::Proposed)
    return outlines;
  const CompactMap map = proposedMap(making.scene.map);
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane)
    if (const auto lines = outlinesOf(map, plane); !lines.empty())
      outlines.push_back({actorOfOutlines(lines), map.planes[plane].coefficients});
  return outlines;
}

Actors
actorsBefore(const LayerMaking& making,
             SceneLayer layer,
             const Trajectory& poses,
             std::size_t step)
{
  if (layer == SceneLayer::Points)
    return pointLayer(making, pointsUnder(making.scene, poses, step), poses);
  return wayOf(making, poses);
}

Trajectory
posesBetween(const LayeredScene& scene, double share)
{
  const Trajectory& after = scene.map.trajectory;
  Trajectory between = scene.trajectory_before;
  for (std::size_t i = 0; i < between.poses.size(); ++i) {
    Eigen::Isometry3d& pose = between.poses[i];
    const Eigen::Quaterniond from(pose.linear()), to(after.poses[i].linear());
    pose.linear() = from.slerp(share, to).toRotationMatrix();
    pose.translation() =
        (1 - share) * pose.translation() + share * after.poses[i].translation();
  }
  return between;
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
pointsUnder(const LayeredScene& scene, const Trajectory& poses, std::size_t step)
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
  PCLPointCloud2 cloud;
  cloud.fields = scene.points.fields;
  cloud.point_step = scene.points.point_step;
  const auto motions = motionsOf(scene.map.trajectory, poses);
  const std::size_t size = std::size_t{scene.points.width} * scene.points.height;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>((size + step - 1) / step);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize(std::size_t{cloud.width} * cloud.point_step);
  std::uint8_t* bytes = cloud.data.data();
  for (std::size_t i = 0; i < size; i += step, bytes += cloud.point_step) {
    std::memcpy(bytes, &scene.points.data[i * cloud.point_step], cloud.point_step);
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
