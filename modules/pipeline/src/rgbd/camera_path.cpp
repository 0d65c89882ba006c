#include "rgbd/camera_path.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl::acmap {

std::vector<std::size_t>
risingOrder(const std::vector<double>& stamps)
{
  std::vector<std::size_t> order(stamps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return stamps[a] < stamps[b];
  });
  return order;
}

CameraPath::CameraPath(const Trajectory& trajectory, double gap, double gap_alone)
: gap_(gap)
, gap_alone_(gap_alone)
{
  for (const std::size_t i : risingOrder(trajectory.stamps)) {
    stamps_.push_back(trajectory.stamps[i]);
    poses_.push_back(trajectory.poses[i]);
  }
}

std::optional<Eigen::Isometry3d>
CameraPath::at(double stamp) const
{
  const auto next = std::lower_bound(stamps_.begin(), stamps_.end(), stamp);
  const auto after = static_cast<std::size_t>(next - stamps_.begin());
  const double infinity = std::numeric_limits<double>::infinity();
  const double to_next = next != stamps_.end() ? *next - stamp : infinity;
  const double to_last = after > 0 ? stamp - stamps_[after - 1] : infinity;
  if (to_next <= gap_ && to_last <= gap_)
    return between(after, stamp);
  if (to_next <= gap_alone_)
    return poses_[after];
  if (to_last <= gap_alone_)
    return poses_[after - 1];
  return {};
}

Eigen::Isometry3d
CameraPath::between(std::size_t after, double stamp) const
{
  const double begin = stamps_[after - 1];
  const double share = (stamp - begin) / (stamps_[after] - begin);
  const Eigen::Isometry3d& a = poses_[after - 1];
  const Eigen::Isometry3d& b = poses_[after];
  const Eigen::Quaterniond turn(a.linear());
  Eigen::Isometry3d pose(turn.slerp(share, Eigen::Quaterniond(b.linear())));
  pose.translation() = (1.0 - share) * a.translation() + share * b.translation();
  return pose;
}

} // namespace pcl::acmap
