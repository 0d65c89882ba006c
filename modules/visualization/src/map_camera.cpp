#include "map_camera.h"

#include "camera_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;
using Points = std::vector<Eigen::Vector3f>;

/** \brief Position of an eye and a horizontal direction. */
struct EyeDirection {
  Eigen::Vector3d eye;
  Eigen::Vector3d direction;
};

/** Maximum number of poses of a trajectory that are tried. */
constexpr std::size_t max_poses = 16;

double
freeWay(const std::vector<MapFaces>& faces, const Vector3d& eye, const Vector3d& ahead)
{
  const auto hit = firstHit(faces, eye, ahead, false);
  // a ray that leaves through a gap in the walls does not count
  return hit ? hit->distance : 0;
}

std::vector<Vector3d>
eyesOf(const Trajectory& trajectory, const Vector3d& middle)
{
  std::vector<Vector3d> eyes;
  const std::size_t step = trajectory.poses.size() / max_poses + 1;
  for (std::size_t i = 0; i < trajectory.poses.size(); i += step)
    if (trajectory.poses[i].matrix().allFinite())
      eyes.push_back(trajectory.poses[i].translation());
  if (eyes.empty())
    eyes.push_back(middle);
  return eyes;
}

/** \brief Selects the pose and the direction along the walls of a map with the longest
 * view.
 * \param[in] middle position that is used if there is no pose */
EyeDirection
longestSight(const Trajectory& trajectory,
             const std::vector<MapFaces>& faces,
             const Vector3d& middle,
             const MapFrame& frame)
{
  const Vector3d across = frame.up.cross(frame.along);
  const std::vector<Vector3d> eyes = eyesOf(trajectory, middle);
  EyeDirection best = {eyes[0], frame.along};
  double farthest = 0;
  for (const Vector3d& eye : eyes)
    for (const Vector3d& ahead :
         {frame.along, Vector3d(-frame.along), across, Vector3d(-across)})
      // also looks slightly to each side, so that a narrow gap does not win
      if (const double way =
              freeWay(faces, eye, ahead) +
              freeWay(faces, eye, (ahead + 0.1 * frame.up.cross(ahead)).normalized()) +
              freeWay(faces, eye, (ahead - 0.1 * frame.up.cross(ahead)).normalized());
          way > farthest * (1 + 1e-6)) {
        farthest = way;
        best = {eye, ahead};
      }
  return best;
}

constexpr double outside_yaw = 25 * degree;
constexpr double outside_pitch = 45 * degree;
constexpr double turned_share = 0.1;
constexpr double one_sided_share = 0.6; // of the area faces one side, as in one view
constexpr double front_yaw = 18 * degree;
constexpr double front_pitch = 15 * degree;
constexpr double inside_angle = 70;         // degrees
constexpr double inside_pitch = 6 * degree; // slightly downwards
constexpr double plan_margin = 1.15;        // leaves room for the scale bar

/** \brief Extent of the samples along a direction, without outliers. */
std::pair<double, double>
endsAlong(const Points& samples, const RobustBox& box, const Vector3d& direction)
{
  constexpr double stray_factor = 3;
  double minimum = INFINITY, maximum = -INFINITY;
  for (const Eigen::Vector3f& sample : samples)
    if (box.contains(sample.cast<double>(), stray_factor)) {
      minimum = std::min(minimum, sample.cast<double>().dot(direction));
      maximum = std::max(maximum, sample.cast<double>().dot(direction));
    }
  return {minimum, maximum};
}

Camera
planCamera(const Points& samples, const MapFrame& frame, const MapView& view)
{
  const RobustBox box(samples);
  Camera camera{};
  camera.vertical = frame.up;
  camera.up = frame.up.cross(frame.along);
  const auto [left, right] = endsAlong(samples, box, frame.along);
  const auto [bottom, top] = endsAlong(samples, box, camera.up);
  const auto [low, high] = endsAlong(samples, box, frame.up);
  camera.focus = (left + right) / 2 * frame.along + (bottom + top) / 2 * camera.up +
                 (low + high) / 2 * frame.up;
  if (view.look)
    camera.focus = view.look->cast<double>();
  const double aspect = static_cast<double>(view.width) / view.height;
  camera.parallel_height =
      std::max({top - bottom, (right - left) / aspect, 1e-3}) * plan_margin;
  camera.position = camera.focus + frame.up * (high - low + camera.parallel_height);
  camera.view_angle = inside_angle;
  setDepths(camera, samples, box);
  return camera;
}

Camera
insideCamera(const CompactMap& map,
             const std::vector<MapFaces>& faces,
             const Points& samples,
             const MapFrame& frame,
             const MapView& view)
{
  const EyeDirection sight =
      longestSight(map.trajectory, faces, RobustBox(samples).middle, frame);
  SceneView there = view;
  if (!there.from)
    there.from = sight.eye.cast<float>();
  if (!there.look)
    there.look =
        *there.from + turned(sight.direction, frame.up, 0, inside_pitch).cast<float>();
  Camera camera = lookAlong(samples, sight.direction, frame.up, there);
  camera.view_angle = inside_angle;
  return camera;
}

/** \brief Sum of the normals of faces, times their areas, and that of the areas. */
std::pair<Vector3d, double>
facingOf(const std::vector<MapFaces>& faces)
{
  Vector3d facing = Vector3d::Zero();
  double area = 0;
  for (const MapFaces& part : faces)
    for (const auto& face : part.faces)
      for (std::size_t i = 2; i < face.size(); ++i) {
        const Vector3d a = part.points[face[0]].cast<double>();
        const Vector3d normal = (part.points[face[i - 1]].cast<double>() - a)
                                    .cross(part.points[face[i]].cast<double>() - a) /
                                2;
        facing += normal;
        area += normal.norm();
      }
  return {facing, area};
}

Camera
outsideCamera(const std::vector<MapFaces>& faces,
              const Points& samples,
              const MapFrame& frame,
              const MapView& view)
{
  Vector3d across = frame.up.cross(frame.along);
  const auto [facing, area] = facingOf(faces);
  if (facing.dot(across) > turned_share * area)
    across = -across; // most of the walls would look away
  const Vector3d level = facing - facing.dot(frame.up) * frame.up;
  const bool is_one_sided = level.norm() > one_sided_share * area;
  const Vector3d ahead =
      is_one_sided ? turned(-level.normalized(), frame.up, front_yaw, front_pitch)
                   : turned(across, frame.up, outside_yaw, outside_pitch);
  return lookAlong(samples, ahead, frame.up, view);
}

} // namespace

Camera
placeMapCamera(const CompactMap& map,
               const std::vector<MapFaces>& faces,
               const Points& samples,
               const MapFrame& frame,
               const MapView& view)
{
  requireSound(view);
  switch (view.place) {
  case MapView::Place::Plan:
    return planCamera(samples, frame, view);
  case MapView::Place::Inside:
    return insideCamera(map, faces, samples, frame, view);
  case MapView::Place::Outside:
    break;
  }
  return outsideCamera(faces, samples, frame, view);
}

} // namespace pcl::acmap
