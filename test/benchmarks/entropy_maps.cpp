#include "entropy_maps.h"

#include <pcl/core/random.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t seed = 1;

/** A wall segment along one axis (0: x, 1: z). */
struct EntropyWall {
  int along;
  double at, begin, end; ///< metres
};

constexpr double building = 30, room = 6, door = 1.2;

/** Rows of rooms with a door in the middle of each inner wall. */
std::vector<EntropyWall>
wallsOfRooms()
{
  std::vector<EntropyWall> walls;
  for (const int along : {0, 1})
    for (double at = 0; at <= building; at += room)
      for (double begin = 0; begin < building; begin += room) {
        if (at == 0 || at == building) {
          walls.push_back({along, at, begin, begin + room});
          continue;
        }
        const double middle = begin + room / 2;
        walls.push_back({along, at, begin, middle - door / 2});
        walls.push_back({along, at, middle + door / 2, begin + room});
      }
  return walls;
}

/** First intersection of a beam. */
struct WallRayHit {
  double range = 1e9;
  int along = 0; ///< axis of the wall
};

WallRayHit
cast(const std::vector<EntropyWall>& walls,
     const Eigen::Vector2d& from,
     const Eigen::Vector2d& way)
{
  WallRayHit hit;
  for (const EntropyWall& wall : walls) {
    const int across = 1 - wall.along;
    const double range = (wall.at - from[across]) / way[across];
    const double place = from[wall.along] + range * way[wall.along];
    if (range > 0 && range < hit.range && place >= wall.begin && place <= wall.end)
      hit = {range, wall.along};
  }
  return hit;
}

void
addScan(const std::vector<EntropyWall>& walls, Random& random, EntropyMap& map)
{
  constexpr int beams = 180;
  constexpr double noise = 0.01, min_slant = 0.15;
  const PlanarPose& pose = map.poses.back();
  auto& points = map.points.emplace_back();
  auto& normals = map.normals.emplace_back();
  auto& weights = map.weights.emplace_back();
  for (int beam = 0; beam < beams; ++beam) {
    const double angle = M_PI * (beam + 0.5) / beams;
    const Eigen::Vector2d local(std::cos(angle), std::sin(angle));
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    const Eigen::Vector2d way(c * local[0] + s * local[1], c * local[1] - s * local[0]);
    const WallRayHit hit = cast(walls, {pose.x, pose.z}, way);
    const double range = hit.range + noise * random.normal();
    const double slant = std::abs(way[1 - hit.along]);
    points.emplace_back((range * Eigen::Vector3d(local[0], 0, local[1])).cast<float>());
    normals.emplace_back(
        (hit.along == 0 ? Eigen::Vector3d(-s, 0, c) : Eigen::Vector3d(c, 0, s))
            .cast<float>());
    weights.push_back(static_cast<float>(
        std::clamp(range * M_PI / beams / std::max(slant, min_slant), 0.02, 0.5)));
  }
}

} // namespace

std::size_t
EntropyMap::size() const
{
  std::size_t sum = 0;
  for (const auto& cloud : points)
    sum += cloud.size();
  return sum;
}

std::vector<PosedPoints>
EntropyMap::observations() const
{
  std::vector<PosedPoints> all;
  constexpr std::size_t stride = sizeof(Eigen::Vector3f);
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back({{points[i].data(), stride, points[i].size()},
                   {normals[i].data(), stride, normals[i].size()},
                   poses[i],
                   weights.empty() ? nullptr : weights[i].data()});
  return all;
}

EntropyMap
makePaperMap()
{
  const SimulatedScene scene = standardScene("corridor");
  const std::vector<TruthPlane> planes = scene.geometry.planes();
  EntropyMap map;
  map.name = "corridor";
  for (std::size_t view = 0; view < scene.views.size(); ++view) {
    map.poses.push_back(planarPartOf(scene.views[0].inverse() * scene.views[view]));
    auto& points = map.points.emplace_back();
    auto& normals = map.normals.emplace_back();
    const Eigen::Matrix3d to_camera = scene.views[view].linear().transpose();
    for (const ObservationPixel& pixel : observe(scene, view, seed).pixels) {
      if (!std::isfinite(pixel.x))
        continue;
      points.emplace_back(pixel.x, pixel.y, pixel.z);
      normals.emplace_back(
          pixel.label == 0
              ? Eigen::Vector3f::Constant(std::nanf(""))
              : Eigen::Vector3f(
                    (to_camera * planes[pixel.label - 1].coefficients.head<3>())
                        .cast<float>()));
    }
  }
  return map;
}

EntropyMap
makeLaserMap()
{
  constexpr int scans = 200;
  EntropyMap map;
  map.name = "rooms";
  const std::vector<EntropyWall> walls = wallsOfRooms();
  Random random(seed);
  for (int scan = 0; scan < scans; ++scan) {
    const int cell = scan % 25;
    map.poses.push_back({room * (cell % 5) + random.uniform(1, room - 1),
                         room * (cell / 5) + random.uniform(1, room - 1),
                         random.uniform(-M_PI, M_PI)});
    addScan(walls, random, map);
  }
  return map;
}

} // namespace pcl::acmap::bench
