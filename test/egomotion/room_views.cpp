#include "room_views.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

constexpr double full_turn = 6.283185307179586;

/** \brief Where a ray enters and leaves a box, as multiples of its direction. */
std::pair<double, double>
crossing(const Box& box, const Eigen::Vector3d& from, const Eigen::Vector3d& ray)
{
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - from[axis]) / ray[axis];
    const double b = (box.max()[axis] - from[axis]) / ray[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

double
lengthOf(const Room& room, const Eigen::Vector3d& from, const Eigen::Vector3d& ray)
{
  double length = crossing(room.walls, from, ray).second;
  for (const Box& thing : room.things) {
    const auto [enter, leave] = crossing(thing, from, ray);
    if (enter > 0 && enter < leave)
      length = std::min(length, enter);
  }
  return length;
}

} // namespace

SpacePaint::SpacePaint(std::uint64_t seed, double contrast)
: waves_(40)
, amplitude_(contrast * std::sqrt(2.0 / 40))
{
  Random random(seed);
  for (Wave& wave : waves_) {
    // in separate statements: the evaluation order of arguments is unspecified
    const double z = random.normal(), y = random.normal(), x = random.normal();
    const Eigen::Vector3d direction(x, y, z);
    wave.frequency = full_turn / random.uniform(0.1, 0.6) * direction.normalized();
    wave.phase = random.uniform(0, full_turn);
  }
}

double
SpacePaint::operator()(const Eigen::Vector3d& place) const
{
  double sum = 0;
  for (const Wave& wave : waves_)
    sum += std::cos(wave.frequency.dot(place) + wave.phase);
  return 128 + amplitude_ * sum;
}

Room::Room(std::uint64_t seed)
: brightness(
      [paint = SpacePaint(seed)](const Eigen::Vector3d& place, const Eigen::Vector2d&) {
        return paint(place);
      })
{}

PointCloud<PointXYZRGBSigma>::Ptr
viewOf(const Room& room,
       const Eigen::Isometry3d& T_room_camera,
       const RoomCamera& camera)
{
  PointCloud<PointXYZRGBSigma>::Ptr cloud(
      new PointCloud<PointXYZRGBSigma>(static_cast<std::uint32_t>(camera.width),
                                       static_cast<std::uint32_t>(camera.height)));
  const Eigen::Vector2d middle((camera.width - 1) / 2.0, (camera.height - 1) / 2.0);
  Random random(camera.seed);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const Eigen::Vector2d pixel(static_cast<double>(i % cloud->width),
                                static_cast<double>(i / cloud->width));
    const Eigen::Vector3d ray = ((pixel - middle) / camera.focal_length).homogeneous();
    const Eigen::Vector3d seen =
        lengthOf(room, T_room_camera.translation(), T_room_camera.linear() * ray) * ray;
    const double value =
        camera.gain * room.brightness(T_room_camera * seen, pixel) + camera.offset;
    PointXYZRGBSigma& point = (*cloud)[i];
    point.sigma = static_cast<float>(camera.sigma * seen.z() * seen.z());
    const double error = camera.noise > 0 ? camera.noise * random.normal() : 0;
    point.getVector3fMap() =
        (seen + error * point.sigma * ray.normalized()).cast<float>();
    point.r = point.g = point.b =
        static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  }
  return cloud;
}

Eigen::Isometry3d
poseOf(const Eigen::Vector3d& place, double turn, double tilt, double roll)
{
  Eigen::Isometry3d pose(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()) *
                         Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()));
  pose.translation() = place;
  return pose;
}

Eigen::Matrix<double, 6, 1>
motionBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to)
{
  const Eigen::Isometry3d step = to * from.inverse();
  const Eigen::AngleAxisd turn(step.linear());
  Eigen::Matrix<double, 6, 1> motion;
  motion << step.translation(), turn.angle() * turn.axis();
  return motion;
}

} // namespace pcl::acmap::test
