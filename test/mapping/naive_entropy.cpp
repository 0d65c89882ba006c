#include "naive_entropy.h"

#include <pcl/core/random.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <map>

namespace pcl::acmap::test {
namespace {

using Histogram = std::map<std::array<long, 3>, double>;

double
splineAt(double t)
{
  t = std::abs(t);
  if (t >= 1.5)
    return 0;
  return t > 0.5 ? 0.5 * (1.5 - t) * (1.5 - t) : 0.75 - t * t;
}

/** Weight of a point at u in bin i of width 1. */
double
shareOf(double u, long i, bool splines)
{
  if (splines)
    return splineAt(u - (static_cast<double>(i) + 0.5));
  return std::floor(u) == static_cast<double>(i) ? 1 : 0;
}

std::map<long, double>
gaussian(double sigma)
{
  std::map<long, double> kernel;
  const long radius = std::lround(std::ceil(3 * sigma));
  double sum = 0;
  for (long i = -radius; i <= radius; ++i)
    sum += kernel[i] =
        i == 0 ? 1 : std::exp(-static_cast<double>(i * i) / (2 * sigma * sigma));
  for (auto& [i, weight] : kernel)
    weight /= sum;
  return kernel;
}

double
entropyOf(const Histogram& histogram)
{
  double sum = 0, entropy = 0;
  for (const auto& [bin, value] : histogram)
    sum += value;
  for (const auto& [bin, value] : histogram)
    if (value > 0)
      entropy -= value / sum * std::log2(value / sum);
  return entropy;
}

void
add(Histogram& q,
    const Eigen::Vector3d& place,
    const Eigen::Vector3d& normal,
    const NaiveEntropySettings& s)
{
  const double u = place[0] / s.bin;
  const double v = place[2] / s.bin;
  const long i = std::lround(std::floor(u));
  const long j = std::lround(std::floor(v));
  const bool upright =
      normal.allFinite() && std::hypot(normal[0], normal[2]) > std::abs(normal[1]);
  const double w = std::atan2(normal[2], normal[0]) / (M_PI / 4);
  for (long a = i - 2; a <= i + 2; ++a)
    for (long b = j - 2; b <= j + 2; ++b) {
      const double share = shareOf(u, a, s.splines) * shareOf(v, b, s.splines);
      if (share == 0)
        continue;
      if (!s.directions || !upright)
        q[{a, b, 8}] += share;
      for (long c = -10; c <= 10 && s.directions && upright; ++c)
        q[{a, b, (c + 16) % 8}] += share * shareOf(w, c, s.splines);
    }
}

} // namespace

MapEntropyTerms
naiveEntropy(const PosedClouds& map, const NaiveEntropySettings& settings)
{
  Histogram q;
  MapEntropyTerms terms;
  for (std::size_t i = 0; i < map.clouds.size(); ++i) {
    const PlanarPose& pose = map.poses[i];
    const Eigen::AngleAxisd turn(pose.theta, Eigen::Vector3d::UnitY());
    for (const PointNormal& point : *map.clouds[i]) {
      const Eigen::Vector3d place = turn * point.getVector3fMap().cast<double>() +
                                    Eigen::Vector3d(pose.x, 0, pose.z);
      const Eigen::Vector3d normal = turn * point.getNormalVector3fMap().cast<double>();
      add(q, place, normal, settings);
      ++terms.points;
    }
  }
  const auto kernel = gaussian(settings.sigma / settings.bin);
  Histogram smooth, on_x, on_z;
  for (const auto& [bin, value] : q)
    for (const auto& [a, weight_a] : kernel)
      for (const auto& [b, weight_b] : kernel)
        smooth[{bin[0] + a, bin[1] + b, bin[2]}] += value * weight_a * weight_b;
  for (const auto& [bin, value] : smooth) {
    on_x[{bin[0], 0, 0}] += value;
    on_z[{bin[1], 0, 0}] += value;
  }
  terms.joint = entropyOf(smooth);
  terms.along_x = entropyOf(on_x);
  terms.along_z = entropyOf(on_z);
  terms.total = terms.joint + settings.mu * (terms.along_x + terms.along_z);
  return terms;
}

namespace {

PointNormal
toPoint(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
{
  PointNormal point;
  point.getVector3fMap() = place.cast<float>();
  point.getNormalVector3fMap() = normal.cast<float>();
  return point;
}

/** A point in the room's frame; normals point into the room, those of the box out of
 * it. */
PointNormal
roomPoint(Random& random)
{
  const double height = 2 * random.uniform() - 1.5;
  const double along = random.uniform();
  const double noise = 0.005 * random.normal();
  const double kind = random.uniform();
  if (kind < 0.3)
    return toPoint({6 * along, height, noise}, {0, 0, 1});
  if (kind < 0.55)
    return toPoint({6 * along, height, 4 + noise}, {0, 0, -1});
  if (kind < 0.75)
    return toPoint({noise, height, 4 * along}, {1, 0, 0});
  if (kind < 0.85)
    return toPoint({4 + along, height, 3 + noise}, {0, 0, -1});
  if (kind < 0.95)
    return toPoint({4 + noise, height, 3 + along}, {-1, 0, 0});
  return toPoint({6 * along, 1.5 + noise, 4 * random.uniform()}, {0, -1, 0});
}

} // namespace

PosedClouds
makeRoomViews(std::size_t views, std::size_t points, std::uint64_t seed)
{
  Random random(seed);
  PosedClouds map;
  for (std::size_t i = 0; i < views; ++i) {
    const double t = static_cast<double>(i);
    map.poses.push_back({1.03 + 0.31 * t, 1.21 + 0.17 * t, 0.23 * t - 0.4});
    const Eigen::AngleAxisd back(-map.poses[i].theta, Eigen::Vector3d::UnitY());
    const Eigen::Vector3d origin(map.poses[i].x, 0, map.poses[i].z);
    map.clouds.emplace_back(new PointCloud<PointNormal>);
    for (std::size_t p = 0; p < points; ++p) {
      const PointNormal point = roomPoint(random);
      map.clouds[i]->push_back(
          toPoint(back * (point.getVector3fMap().cast<double>() - origin),
                  back * point.getNormalVector3fMap().cast<double>()));
    }
  }
  return map;
}

PosedClouds
makeThinWall(double thickness)
{
  PosedClouds map;
  Random random(3);
  for (const double side : {-1.0, 1.0}) {
    map.poses.push_back({0, 0.04 + 2 * side, 0});
    map.clouds.emplace_back(new PointCloud<PointNormal>);
    for (int i = 0; i < 2000; ++i)
      map.clouds.back()->push_back(toPoint(
          {4 * random.uniform() - 2, 0, side * (thickness / 2 - 2)}, {0, 0, side}));
  }
  return map;
}

} // namespace pcl::acmap::test
