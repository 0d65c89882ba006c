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

double
shareOf(std::size_t part, std::size_t whole)
{
  return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

} // namespace

struct RayEvidence::Counts {
  std::size_t rays = 0;
  std::size_t contradicted[2] = {0, 0}, confirmed[2] = {0, 0}; ///< near, far
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
{
  std::size_t points = 0;
  for (const LevelledPoints& seen : observations) {
    points += seen.points.size();
    for (const Eigen::Vector3f& normal : seen.normals)
      has_normals_ = has_normals_ || normal.allFinite();
  }
  every_ = points / max_rays + 1;
}

template <typename Predicate>
void
RayEvidence::countWalls(const Ray& ray,
                        std::uint64_t cell,
                        const WallTable& table,
                        const Eigen::Vector2d& direction,
                        const Predicate& counts,
                        std::size_t points[2]) const
{
  table.visit(cell, [&](const SeenWall& wall) {
    const std::size_t other = wall.observation;
    const std::size_t apart =
        std::max(other, ray.observation) - std::min(other, ray.observation);
    const double cosine = wall.normal_x * direction[0] + wall.normal_z * direction[1];
    if (apart > 0 && (!has_normals_ || counts(cosine)))
      points[apart > neighbours] += wall.points;
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
  for (std::size_t i = 0; i < seen.points.size(); i += every_) {
    const Eigen::Vector3d point = seen.points[i].cast<double>();
    if (!(point.norm() <= longest_ray))
      continue;
    ++counts.rays;
    const Ray ray(observation, point, seen.sensor_height, motion, cell_);
    const Eigen::Vector2d way = ray.way.normalized();
    bool contradicted[2] = {false, false};
    for (double t = start; t < ray.range - margin; t += step * cell_) {
      std::size_t points[2] = {0, 0};
      const auto crosses = [](double cosine) { return std::abs(cosine) > crossing; };
      countWalls(ray, ray.cellBefore(ray.range - t), table, way, crosses, points);
      for (const int side : {0, 1})
        contradicted[side] = contradicted[side] || points[side] >= min_points;
    }
    std::size_t confirming[2] = {0, 0};
    Eigen::Vector2d normal(0, 0);
    if (!seen.normals.empty())
      normal = motion.rotation() *
               Eigen::Vector2d(seen.normals[i][0], seen.normals[i][2]).cast<double>();
    normal *= (normal.dot(way) > 0 ? -1 : 1) / std::max(1e-9, normal.norm());
    const auto agrees = [](double cosine) { return cosine > agreeing; };
    countWalls(ray, ray.cellBefore(0), table, normal, agrees, confirming);
    for (const int side : {0, 1}) {
      counts.contradicted[side] += contradicted[side];
      counts.confirmed[side] += confirming[side] > 0;
    }
  }
  return counts;
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
}

} // namespace pcl::acmap
