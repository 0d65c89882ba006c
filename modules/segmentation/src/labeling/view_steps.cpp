#include "labeling/view_steps.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/LU>

#include <cmath>
#include <map>
#include <optional>

namespace pcl::acmap::labeling {
namespace {

constexpr double min_points = 30; // of each plane in an observation

/** May an unlabelled point belong to the only plane near it, moved away from it by pose
 * errors? Points without such errors that are off the plane are of no plane. */
bool
isMovedOff(const Sight& sight,
           std::int32_t entry,
           const CandidateGrid& grid,
           const std::vector<KnownPlane>& planes)
{
  const Candidates& candidates = grid[entry];
  if (candidates.size != 1)
    return false;
  const std::int32_t plane = candidates.planes[0];
  const Crossing crossing(sight, planes[static_cast<std::size_t>(plane)].patch);
  return std::abs(crossing.off) < max_drift && grid.homeAt(crossing.foot) == plane;
}

/** Returns for each point the plane on which its observation saw it, -1 for none. */
PointLabels
onPlanes(const Survey& survey,
         const PointLabels& labels,
         const CandidateGrid& grid,
         const RangeNoise& noise,
         const std::vector<KnownPlane>& planes)
{
  PointLabels on(survey.size(), -1);
  parallelForChunks(survey.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int32_t entry = survey.entry(i);
      if (entry < 0 || survey.observation(i) < 0)
        continue;
      const Sight sight = survey.sight(i);
      std::int32_t label = labels[i];
      const bool is_moved = label < 0 && isMovedOff(sight, entry, grid, planes);
      if (is_moved)
        label = grid[entry].planes[0];
      if (label < 0)
        continue;
      const KnownPlane& plane = planes[static_cast<std::size_t>(label)];
      const Crossing crossing(sight, plane.patch);
      const bool is_near =
          crossing.off * crossing.off <= squared_gate * noise.variance(crossing, plane);
      if ((is_near || is_moved) && !grid.hasStrangersAt(crossing.foot, entry))
        on[i] = label;
    }
  });
  return on;
}

/** Points in the frame of a plane: (u, v, height over it). */
struct Group {
  double count = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero(); ///< about the mean
};

Group
groupOf(const Moments& m, const Eigen::Vector3d& origin, const PlanePatch& frame)
{
  Eigen::Matrix3d axes;
  axes << frame.axis_u.transpose(), frame.axis_v.transpose(),
      frame.coefficients.head<3>().transpose();
  Eigen::Matrix3d squares;
  squares << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  const Eigen::Vector3d mean = m.mean();
  Group group;
  group.count = m.count;
  group.mean = axes * (mean + origin - frame.center);
  group.scatter =
      axes * (squares - m.count * mean * mean.transpose()) * axes.transpose();
  return group;
}

/** A measured height with its variance. */
struct MeasuredStep {
  double height;
  double variance;
};

/** The step between two parallel planes by least squares (analysis of covariance). Both
 * have the same tilt, which is the pose error of the observation. */
std::optional<MeasuredStep>
stepBetween(const Group& part, const Group& whole)
{
  const Eigen::Matrix3d scatter = part.scatter + whole.scatter;
  const double freedom = part.count + whole.count - 4;
  constexpr double pose_tilt = 0.0175;    // radians, expected tilt error of a pose
  constexpr double max_independent = 100; // noise of neighbours is correlated
  const double noise = std::max(scatter(2, 2) / freedom, 1e-12);
  const Eigen::Matrix2d information =
      scatter.topLeftCorner<2, 2>() / noise +
      Eigen::Matrix2d::Identity() / (pose_tilt * pose_tilt);
  const Eigen::Matrix2d covariance = information.inverse();
  if (!covariance.allFinite())
    return std::nullopt;
  const Eigen::Vector2d tilt = covariance * scatter.block<2, 1>(0, 2) / noise;
  const Eigen::Vector3d way = part.mean - whole.mean;
  return MeasuredStep{way.z() - tilt.dot(way.head<2>()),
                      noise * (1 / std::min(part.count, max_independent) +
                               1 / std::min(whole.count, max_independent)) +
                          way.head<2>().dot(covariance * way.head<2>())};
}

/** The weighted mean; its variance also includes the differences between the steps. */
MeasuredStep
meanOf(const std::vector<MeasuredStep>& steps)
{
  double weights = 0, sum = 0, squares = 0;
  for (const MeasuredStep& step : steps) {
    weights += 1 / step.variance;
    sum += step.height / step.variance;
  }
  const double mean = sum / weights;
  for (const MeasuredStep& step : steps)
    squares += (step.height - mean) * (step.height - mean) / step.variance;
  const double others = static_cast<double>(steps.size()) - 1;
  const double spread = others > 0 ? squares / others : 1;
  return {mean, std::max(spread, 1.0) / weights};
}

} // namespace

ViewSteps::ViewSteps(const Survey& survey,
                     const PointLabels& labels,
                     const CandidateGrid& grid,
                     const RangeNoise& noise,
                     const std::vector<KnownPlane>& planes)
: planes_(planes)
, seen_(planes.size())
{
  const PointLabels on = onPlanes(survey, labels, grid, noise, planes);
  const PlaneMembers members(on.data(), on.size(), planes.size());
  members.forEachPlane([&](std::size_t plane, PlaneMembers::Range range) {
    std::map<std::int32_t, Moments> sums;
    auto last = sums.end();
    for (const std::size_t i : range) {
      const std::int32_t observation = survey.observation(i);
      if (last == sums.end() || last->first != observation)
        last = sums.try_emplace(observation).first;
      last->second += momentsOf(survey.sight(i).point - planes[plane].patch.center);
    }
    for (const auto& [observation, moments] : sums)
      if (moments.count >= min_points)
        seen_[plane].push_back({observation, moments});
  });
}

bool
ViewSteps::ruleOut(double gap,
                   double tolerance,
                   std::size_t part,
                   std::size_t whole) const
{
  const PlanePatch& frame = planes_[whole].patch;
  const Eigen::Vector3d& origin = planes_[part].patch.center;
  std::vector<MeasuredStep> steps;
  auto other = seen_[whole].begin();
  for (const Seen& seen : seen_[part]) {
    while (other != seen_[whole].end() && other->observation < seen.observation)
      ++other;
    if (other == seen_[whole].end() || other->observation != seen.observation)
      continue;
    if (const std::optional<MeasuredStep> step =
            stepBetween(groupOf(seen.moments, origin, frame),
                        groupOf(other->moments, frame.center, frame)))
      steps.push_back(*step);
  }
  if (steps.empty())
    return false;
  const MeasuredStep mean = meanOf(steps);
  const double height = std::abs(mean.height);
  return height < std::min(gap / 2, tolerance) &&
         height + 2 * std::sqrt(mean.variance) < gap;
}

} // namespace pcl::acmap::labeling
