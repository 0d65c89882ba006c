#include "ray_evidence.h"

#include "../entropy/planar_motion.h"
#include "entropy_search.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

constexpr double start = 0.3;  ///< metres from the sensor, to exclude the robot
constexpr double margin = 0.5; ///< metres before a ray's end, to exclude its wall
constexpr double step = 0.7;   ///< cells
constexpr double min_cell = 0.1, max_cell = 0.2; ///< metres
constexpr double crossing = 0.7;                 ///< minimum |cosine| of ray and normal
constexpr double agreeing = 0.9; ///< minimum cosine of two normals of a wall
constexpr std::size_t max_rays = 200000;
constexpr std::size_t min_points = 2; ///< points of others that form a wall
constexpr std::size_t max_groups = 256;
/** Neighbouring rays meet the same wall: so many of them count as one. */
constexpr double rays_alike = 6;
constexpr double confidence = 2; ///< standard deviations

double
shareOf(std::size_t part, std::size_t whole)
{
  return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/** Lower end of Wilson's confidence interval of a share. */
double
lowerShare(double part, double whole)
{
  if (!(part > 0))
    return 0;
  const double n = whole / rays_alike, share = part / whole;
  const double z2 = confidence * confidence;
  const double spread =
      confidence * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n));
  return std::max(0.0, (share + z2 / (2 * n) - spread) / (1 + z2 / n));
}

} // namespace

struct RayEvidence::Counts {
  std::size_t rays = 0;
  std::size_t contradicted[2] = {0, 0}, confirmed[2] = {0, 0}; ///< near, far
  /** By groups of the observations that contradict or, otherwise, confirm a ray. */
  std::vector<std::uint32_t> contradicted_by, confirmed_by;
};

/** Points of other observations at a place on a ray, and the groups that saw a wall
 * there. */
class RayEvidence::Crossing {
public:
  Crossing(std::size_t observation, std::size_t group)
  : observation_(observation)
  , group_(group)
  {}

  void
  add(std::size_t other, std::size_t points, std::vector<char>& groups)
  {
    const std::size_t apart =
        std::max(other, observation_) - std::min(other, observation_);
    points_[apart > neighbours] += points;
    if (other / group_ != last_group_)
      group_points_ = 0;
    last_group_ = other / group_;
    group_points_ += points;
    if (group_points_ >= min_points)
      groups[last_group_] = 1;
  }

  bool
  isWall(int side) const
  {
    return points_[side] >= min_points;
  }

private:
  std::size_t observation_, group_;
  std::size_t points_[2] = {0, 0}; ///< near, far
  std::size_t last_group_ = static_cast<std::size_t>(-1), group_points_ = 0;
};

/** A ray from a sensor to a point, in the map. */
struct RayEvidence::Ray {
  Ray(std::size_t number,
      const Eigen::Vector3d& point,
      double height,
      const PlanarMotion& motion,
      double edge)
  : observation(number)
  , cell(edge)
  , end(motion.place(point[0], point[2]))
  , end_y(point[1])
  , range((point - Eigen::Vector3d(0, height, 0)).norm())
  , way((end - motion.place(0, 0)) / std::max(1e-9, range))
  , fall((point[1] - height) / std::max(1e-9, range))
  {}

  /** \param[in] left distance to the end, metres */
  std::uint64_t
  cellBefore(double left) const
  {
    return wallCellOf(end - left * way, end_y - left * fall, cell);
  }

  std::size_t observation;
  double cell; ///< metres, edge length of cells
  Eigen::Vector2d end;
  double end_y;
  double range;        ///< metres
  Eigen::Vector2d way; ///< direction in XZ, per metre of the ray
  double fall;         ///< change of y per metre of the ray
};

RayEvidence::RayEvidence(const std::vector<LevelledPoints>& observations,
                         double bin_size)
: observations_(observations)
, cell_(std::clamp(2 * bin_size, min_cell, max_cell))
, group_(std::max(neighbours / 2, (observations.size() + max_groups - 1) / max_groups))
{
  std::size_t points = 0;
  for (const LevelledPoints& seen : observations) {
    points += seen.points.size();
    for (const Eigen::Vector3f& normal : seen.normals)
      has_normals_ = has_normals_ || normal.allFinite();
  }
  every_ = points / max_rays + 1;
}

template <typename Predicate, typename Visit>
void
RayEvidence::visitWalls(const Ray& ray,
                        std::uint64_t cell,
                        const WallTable& table,
                        const Eigen::Vector2d& direction,
                        const Predicate& counts,
                        const Visit& visit) const
{
  table.visit(cell, [&](const SeenWall& wall) {
    const double cosine = wall.normal_x * direction[0] + wall.normal_z * direction[1];
    if (wall.observation != ray.observation && (!has_normals_ || counts(cosine)))
      visit(wall.observation, wall.points);
  });
}

RayEvidence::Counts
RayEvidence::castRays(std::size_t observation,
                      const PlanarPose& pose,
                      const WallTable& table) const
{
  const LevelledPoints& seen = observations_[observation];
  const PlanarMotion motion(pose);
  Counts counts;
  counts.contradicted_by.resize(groups());
  counts.confirmed_by.resize(groups());
  std::vector<char> contradicting, confirming;
  for (std::size_t i = 0; i < seen.points.size(); i += every_) {
    const Eigen::Vector3d point = seen.points[i].cast<double>();
    if (!(point.norm() <= longest_ray))
      continue;
    ++counts.rays;
    const Ray ray(observation, point, seen.sensor_height, motion, cell_);
    const Eigen::Vector2d way = ray.way.normalized();
    bool contradicted[2] = {false, false}, confirmed[2] = {false, false};
    contradicting.assign(groups(), 0);
    confirming.assign(groups(), 0);
    for (double t = start; t < ray.range - margin; t += step * cell_) {
      Crossing at(observation, group_);
      visitWalls(
          ray,
          ray.cellBefore(ray.range - t),
          table,
          way,
          [](double cosine) { return std::abs(cosine) > crossing; },
          [&](std::size_t other, std::size_t points) {
            at.add(other, points, contradicting);
          });
      for (const int side : {0, 1})
        contradicted[side] = contradicted[side] || at.isWall(side);
    }
    Eigen::Vector2d normal(0, 0);
    if (!seen.normals.empty())
      normal = motion.rotation() *
               Eigen::Vector2d(seen.normals[i][0], seen.normals[i][2]).cast<double>();
    normal *= (normal.dot(way) > 0 ? -1 : 1) / std::max(1e-9, normal.norm());
    visitWalls(
        ray,
        ray.cellBefore(0),
        table,
        normal,
        [](double cosine) { return cosine > agreeing; },
        [&](std::size_t other, std::size_t) {
          const std::size_t apart =
              std::max(other, observation) - std::min(other, observation);
          confirmed[apart > neighbours] = true;
          confirming[other / group_] = 1;
        });
    for (const int side : {0, 1}) {
      counts.contradicted[side] += contradicted[side];
      counts.confirmed[side] += confirmed[side];
    }
    for (std::size_t group = 0; group < groups(); ++group) {
      counts.contradicted_by[group] += contradicting[group] != 0;
      counts.confirmed_by[group] += confirming[group] > contradicting[group];
    }
  }
  return counts;
}

void
RayEvidence::judgePairs(const std::vector<Counts>& counts, MapEvidence& evidence) const
{
  const std::size_t size = groups();
  std::vector<double> contradicted(size * size), all(size * size);
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t other = 0; other < size; ++other) {
      const std::size_t own = i / group_;
      const std::size_t pair = std::min(own, other) * size + std::max(own, other);
      contradicted[pair] += counts[i].contradicted_by[other];
      all[pair] += counts[i].contradicted_by[other] + counts[i].confirmed_by[other];
    }
  double far_rays = 0, far_contradicted = 0;
  evidence.pair_contradictions = 0;
  for (std::size_t first = 0; first < size; ++first)
    for (std::size_t second = first; second < size; ++second) {
      const std::size_t pair = first * size + second;
      const double share = lowerShare(contradicted[pair], all[pair]);
      evidence.pair_contradictions = std::max(evidence.pair_contradictions, share);
      if (second < first + 2)
        continue;
      far_rays += all[pair];
      far_contradicted += share > 0.5 ? contradicted[pair] : 0;
    }
  evidence.contradicted_pairs = far_rays > 0 ? far_contradicted / far_rays : 0;
}

void
RayEvidence::judge(const std::vector<PlanarPose>& poses, MapEvidence& evidence) const
{
  std::vector<std::vector<SeenWall>> walls(poses.size());
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) {
    walls[i] = seenWalls(observations_[i], i, poses[i], cell_, has_normals_);
  });
  std::vector<SeenWall> all;
  for (const std::vector<SeenWall>& some : walls)
    all.insert(all.end(), some.begin(), some.end());
  const WallTable table(std::move(all));
  std::vector<Counts> counts(poses.size());
  oneapi::tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t i) {
    counts[i] = castRays(i, poses[i], table);
  });
  Counts sum;
  for (const Counts& one : counts) {
    sum.rays += one.rays;
    for (const int side : {0, 1}) {
      sum.contradicted[side] += one.contradicted[side];
      sum.confirmed[side] += one.confirmed[side];
    }
  }
  const std::size_t near_rays = sum.contradicted[0] + sum.confirmed[0];
  const std::size_t far_rays = sum.contradicted[1] + sum.confirmed[1];
  evidence.rays = sum.rays;
  evidence.near_contradictions = shareOf(sum.contradicted[0], near_rays);
  evidence.far_contradictions = shareOf(sum.contradicted[1], far_rays);
  evidence.near_rays = shareOf(near_rays, sum.rays);
  evidence.far_rays = shareOf(far_rays, sum.rays);
  judgePairs(counts, evidence);
}

} // namespace pcl::acmap
