#include "flight.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double wide_angle = 70;    // degrees, as of a view from inside
constexpr double speed = 1.5;        // m/s
constexpr double turn = 45 * degree; // per second
constexpr double behind = 1.2;       // metres
constexpr double above = 0.4;        // metres
constexpr double ahead = 2;          // distance of the point at which the eye looks,
                                     // metres
constexpr double steady_seconds = 1; // half length of the smoothing window
constexpr int steady_samples = 8;    // on each side

double
secondsBetween(const Isometry3d& a, const Isometry3d& b)
{
  const double way = (b.translation() - a.translation()).norm();
  const Quaterniond from(a.linear()), to(b.linear());
  return std::max(way / speed, from.angularDistance(to) / turn);
}

} // namespace

Flight::Flight(const Trajectory& trajectory)
{
  for (std::size_t row = 0; row < trajectory.poses.size(); ++row) {
    const Isometry3d& pose = trajectory.poses[row];
    if (!pose.matrix().allFinite())
      continue;
    times_.push_back(isEmpty() ? 0
                               : times_.back() + secondsBetween(poses_.back(), pose));
    poses_.push_back(pose);
    rows_.push_back(row);
  }
}

std::size_t
Flight::legAt(double time) const
{
  const auto next = std::upper_bound(times_.begin(), times_.end(), time);
  return next == times_.begin() ? 0
                                : static_cast<std::size_t>(next - times_.begin() - 1);
}

std::size_t
Flight::rowAt(double time) const
{
  return rows_[legAt(time)];
}

Isometry3d
Flight::poseAt(double time) const
{
  const std::size_t leg = legAt(time);
  if (time <= times_.front() || leg + 1 == poses_.size())
    return poses_[leg];
  const Isometry3d &a = poses_[leg], &b = poses_[leg + 1];
  const double share = (time - times_[leg]) / (times_[leg + 1] - times_[leg]);
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() =
      Quaterniond(a.linear()).slerp(share, Quaterniond(b.linear())).toRotationMatrix();
  pose.translation() = (1 - share) * a.translation() + share * b.translation();
  return pose;
}

Camera
Flight::eyeAt(double time) const
{
  Vector3d place = Vector3d::Zero(), forward = place, up = place;
  double sum = 0;
  for (int i = -steady_samples; i <= steady_samples; ++i) {
    const double offset = static_cast<double>(i) / (steady_samples + 1);
    const double weight = 1 - std::abs(offset);
    const Isometry3d pose = poseAt(time + offset * steady_seconds);
    place += weight * pose.translation();
    forward += weight * pose.linear().col(2);
    up -= weight * pose.linear().col(1);
    sum += weight;
  }
  place /= sum;
  // averaged directions can vanish where the sensor rotates abruptly
  const Isometry3d pose = poseAt(time);
  if (forward.norm() < 0.1 * sum || up.norm() < 0.1 * sum ||
      forward.cross(up).norm() < 0.01 * sum * sum) {
    forward = pose.linear().col(2);
    up = -pose.linear().col(1);
  }
  forward.normalize();
  up = (up - up.dot(forward) * forward).normalized();
  Camera camera{};
  camera.position = place - behind * forward + above * up;
  camera.focus = place + ahead * forward;
  camera.up = up;
  camera.view_angle = wide_angle;
  return camera;
}

Camera
cameraAt(const Isometry3d& T_map_camera)
{
  Camera camera{};
  camera.position = T_map_camera.translation();
  camera.focus = camera.position + T_map_camera.linear().col(2);
  camera.up = -T_map_camera.linear().col(1);
  camera.view_angle = wide_angle;
  return camera;
}

} // namespace pcl::acmap
