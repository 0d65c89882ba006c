#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/camera_path.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {

namespace {

using Poses = std::vector<Eigen::Isometry3d>;
using Pair = std::pair<std::size_t, std::size_t>;

constexpr double radian = 180 / M_PI; // degrees

/** Probability that more than half of all are of a kind, as \a count of \a all are; all shares
 * are equally probable before. */
double
majorityOf(std::size_t count, std::size_t all)
{
  const double n = static_cast<double>(all) + 1;
  double sum = 0;
  for (std::size_t j = 0; j <= count; ++j) {
    const auto k = static_cast<double>(j);
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) -
                    n * std::log(2.0));
  }
  return sum;
}

double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double
turnOf(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
{
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/** Each pose with the next one that is away from it. */
std::vector<Pair>
placesOf(const Poses& poses)
{
  constexpr double moved = 0.3, turned = 10 / radian; // metres, radians
  std::vector<Pair> pairs;
  for (std::size_t i = 0, k = 1; k < poses.size(); ++k)
    if ((poses[k].translation() - poses[i].translation()).norm() >= moved ||
        turnOf(poses[i], poses[k]) >= turned) {
      pairs.emplace_back(i, k);
      i = k;
    }
  return pairs;
}

/** The axis about which motions turn most, in the frame of the camera; its y axis if they hardly
 * turn. Errors of the attitude add up in the map, but not there. */
Eigen::Vector3d
axisOf(const std::vector<Eigen::Isometry3d>& motions)
{
  constexpr double least = 0.01; // radians, square root of the sum of the squares
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Isometry3d& motion : motions) {
    const Eigen::AngleAxisd turn(motion.linear());
    sum += turn.angle() * turn.angle() * turn.axis() * turn.axis().transpose();
  }
  if (sum.trace() < least * least)
    return Eigen::Vector3d::UnitY();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
}

} // namespace

CameraPathReport
judgePath(const FreeMotion& evidence)
{
  constexpr double most = 0.99;
  CameraPathReport report;
  report.evidence = evidence;
  report.is_in_space = 2 * evidence.free > evidence.pairs;
  const std::size_t count =
      report.is_in_space ? evidence.free : evidence.pairs - evidence.free;
  report.confidence = std::min(most, majorityOf(count, evidence.pairs));
  return report;
}

FreeMotion
freeMotionOf(const std::vector<Eigen::Isometry3d>& poses)
{
  // what poses of a robot may err by: of a turn, a part
  constexpr double min_tilt = 1 / radian, part_of_turn = 0.03;
  FreeMotion motion;
  std::vector<Eigen::Isometry3d> steps;
  for (const auto& [a, b] : placesOf(poses))
    steps.push_back(poses[a].inverse() * poses[b]);
  if (steps.empty())
    return motion;
  const Eigen::Vector3d axis = axisOf(steps);
  std::vector<double> tilts, rises;
  for (const Eigen::Isometry3d& step : steps) {
    tilts.push_back(angleBetween(axis, step.linear() * axis));
    rises.push_back(std::abs(axis.dot(step.translation())));
    const double turn = Eigen::AngleAxisd(step.linear()).angle();
    motion.free += tilts.back() > min_tilt + part_of_turn * turn ? 1 : 0;
  }
  motion.pairs = steps.size();
  motion.tilt = acmap::medianOf(tilts);
  motion.rise = acmap::medianOf(rises);
  return motion;
}

std::string
textOf(const CameraPathReport& report)
{
  using acmap::shortNumber;
  constexpr double millimetres = 1000;
  const std::string path = report.is_in_space ? "in space" : "planar";
  if (report.evidence.pairs == 0)
    return path + ", assumed (no motion tells)";
  return path + ", " + shortNumber(std::round(100 * report.confidence) / 100) +
         " (tilts by " + shortNumber(radian * report.evidence.tilt) +
         " degrees, rises by " + shortNumber(millimetres * report.evidence.rise) +
         " mm from one place to the next)";
}

} // namespace pcl
