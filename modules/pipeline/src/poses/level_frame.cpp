#include "poses/level_frame.h"

#include <pcl/core/exceptions.h>
#include <pcl/pipeline/map_rows.h>

namespace pcl::acmap {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/** A direction across another one: the part of the first of some that is not nearly along it. */
Vector3d
directionAcross(const Vector3d& up, const Eigen::Matrix3d& candidates)
{
  constexpr double clear = 0.5;
  Vector3d across = Vector3d::Zero();
  for (const int column : {2, 0, 1}) {
    across = candidates.col(column) - up * up.dot(candidates.col(column));
    if (across.norm() > clear)
      break;
  }
  return across.normalized();
}

void
movePoint(const Isometry3d& motion, Eigen::Vector3f& point)
{
  point = (motion * point.cast<double>()).cast<float>();
}

void
movePolygons(const Isometry3d& motion, std::vector<PlanePolygon>& polygons)
{
  for (PlanePolygon& polygon : polygons) {
    for (Eigen::Vector3f& point : polygon.outer)
      movePoint(motion, point);
    for (std::vector<Eigen::Vector3f>& hole : polygon.holes)
      for (Eigen::Vector3f& point : hole)
        movePoint(motion, point);
  }
}

/** \param[in,out] plane unit normal and offset */
void
movePlane(const Isometry3d& motion, Eigen::Vector4d& plane)
{
  plane.head<3>() = motion.linear() * plane.head<3>();
  plane[3] -= plane.head<3>().dot(motion.translation());
}

void
move(const Isometry3d& motion, PlanePatch& plane)
{
  movePlane(motion, plane.coefficients);
  plane.center = motion * plane.center;
  plane.axis_u = motion.linear() * plane.axis_u;
  plane.axis_v = motion.linear() * plane.axis_v;
  movePolygons(motion, plane.polygons);
  movePolygons(motion, plane.proposed);
}

void
move(const Isometry3d& motion, CylinderPatch& cylinder)
{
  cylinder.axis_point = motion * cylinder.axis_point;
  for (Vector3d* const axis :
       {&cylinder.axis_direction, &cylinder.axis_u, &cylinder.axis_v})
    *axis = motion.linear() * *axis;
}

void
move(const Isometry3d& motion, BoxPatch& box)
{
  box.center = motion * box.center;
  box.axes = motion.linear() * box.axes;
  if (!box.slant.isZero(0))
    movePlane(motion, box.slant);
}

void
move(const Isometry3d& motion, RecessPatch& recess)
{
  recess.center = motion * recess.center;
  recess.axes = motion.linear() * recess.axes;
}

} // namespace

LevelFrame::LevelFrame(const Isometry3d& T_map_sensor, const Vector3d& up)
: is_of_map_(false)
{
  const Vector3d ahead = directionAcross(up, T_map_sensor.linear());
  Isometry3d T_map_frame = Isometry3d::Identity();
  T_map_frame.linear() << (-up).cross(ahead), -up, ahead;
  T_map_frame.translation() = T_map_sensor.translation();
  T_frame_map_ = T_map_frame.inverse();
}

Vector3d
LevelFrame::up(const Vector3d& up) const
{
  return is_of_map_ ? up : -Vector3d::UnitY();
}

Isometry3d
LevelFrame::place(const Isometry3d& T_map_camera) const
{
  return is_of_map_ ? T_map_camera : roundedPose(T_frame_map_ * T_map_camera);
}

std::vector<Isometry3d>
LevelFrame::place(const std::vector<Isometry3d>& poses) const
{
  std::vector<Isometry3d> placed;
  for (const Isometry3d& pose : poses)
    placed.push_back(place(pose));
  return placed;
}

Isometry3d
LevelFrame::inMap(const Isometry3d& found, const Isometry3d& given) const
{
  return is_of_map_ ? found : given * (place(given).inverse() * found);
}

Isometry3d
roundedPose(const Isometry3d& pose)
{
  constexpr double steps = 1 << 30; // in a metre
  const Eigen::Matrix4d nearest = (pose.matrix() * steps).array().round() / steps;
  Isometry3d rounded = Isometry3d::Identity();
  rounded.linear() = Eigen::Quaterniond(Eigen::Matrix3d(nearest.topLeftCorner<3, 3>()))
                         .normalized()
                         .toRotationMatrix();
  rounded.translation() = nearest.topRightCorner<3, 1>();
  return rounded;
}

std::optional<Isometry3d>
readablePose(const ObservationSequence& sequence, std::size_t i)
{
  try {
    return sequence.poseInHeader(i);
  }
  catch (const InputFileException&) {
    return std::nullopt;
  }
}

Isometry3d
firstPoseOf(const ObservationSequence& sequence)
{
  for (std::size_t i = 0; i < sequence.size(); ++i)
    if (const auto pose = readablePose(sequence, i))
      return *pose;
  return Isometry3d::Identity();
}

std::vector<Isometry3d>
rectifiedPoses(const LevelFrame& frame,
               const ConsolidatedObservations& observations,
               const Vector3d& up,
               EntropyRectification<PointNormal>& rectification)
{
  const std::vector<Isometry3d>& given = observations.trajectory.poses;
  rectification.setUpDirection(frame.up(up));
  rectification.clear();
  for (std::size_t i = 0; i < given.size(); ++i)
    rectification.addPointCloud(
        observations.clouds[i], frame.place(given[i]), observations.weights[i]);
  rectification.compute();
  std::vector<Isometry3d> poses;
  for (std::size_t i = 0; i < given.size(); ++i)
    poses.push_back(frame.inMap(rectification.getPose(i), given[i]));
  return poses;
}

void
moveTo(const Isometry3d& T_to_from, MappedPlanes& found)
{
  for (PlanePatch& plane : found.planes)
    move(T_to_from, plane);
  for (CylinderPatch& cylinder : found.cylinders)
    move(T_to_from, cylinder);
  for (BoxPatch& box : found.boxes)
    move(T_to_from, box);
  for (RecessPatch& recess : found.recesses)
    move(T_to_from, recess);
  if (found.up)
    found.up = T_to_from.linear().cast<float>() * *found.up;
  found.assumed_up = T_to_from.linear().cast<float>() * found.assumed_up;
  if (found.vertices)
    found.vertices = movedRows(T_to_from, found.vertices);
  if (found.normals)
    found.normals = movedRows(T_to_from, found.normals);
}

void
moveTo(const Isometry3d& T_to_from, PlaneSightings& sightings)
{
  for (SampledRay& ray : sightings.rays) {
    movePoint(T_to_from, ray.sensor);
    movePoint(T_to_from, ray.point);
  }
}

} // namespace pcl::acmap
