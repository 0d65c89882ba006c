#include "rectification_worlds.h"

#include <pcl/core/random.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

Eigen::Vector2d
placeOf(const PlanarPose& pose)
{
  return {pose.x, pose.z};
}

double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** Distance along a ray to the nearest wall, and this wall. */
struct WallHit {
  double range = std::numeric_limits<double>::infinity();
  const PlanWall* wall = nullptr;
};

WallHit
cast(const FloorPlan& plan, const Eigen::Vector2d& from, const Eigen::Vector2d& way)
{
  WallHit hit;
  for (const PlanWall& wall : plan) {
    const Eigen::Vector2d along = wall.to - wall.from;
    const double slope = cross(way, along);
    if (slope == 0)
      continue;
    const double range = cross(wall.from - from, along) / slope;
    const double share = cross(wall.from - from, way) / slope;
    if (range > 0 && share >= 0 && share <= 1 && range < hit.range)
      hit = {range, &wall};
  }
  return hit;
}

PointCloud<PointNormal>::Ptr
scanFrom(const FloorPlan& plan,
         const PlanarPose& pose,
         const LaserSettings& laser,
         Random& random)
{
  PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>);
  const Eigen::Isometry3d back = isometryOf(pose).inverse();
  for (int i = 0; i < laser.beams; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / laser.beams;
    const Eigen::Vector2d way(std::sin(angle), std::cos(angle));
    const WallHit hit = cast(plan, placeOf(pose), way);
    if (!(hit.range < laser.reach))
      continue;
    const Eigen::Vector2d place =
        placeOf(pose) + (hit.range + laser.noise * random.normal()) * way;
    const Eigen::Vector2d along = (hit.wall->to - hit.wall->from).normalized();
    Eigen::Vector3d normal(along[1], 0, -along[0]);
    if (normal[0] * way[0] + normal[2] * way[1] > 0)
      normal = -normal;
    PointNormal point;
    point.getVector3fMap() =
        (back * Eigen::Vector3d(place[0], 0, place[1])).cast<float>();
    point.getNormalVector3fMap() = (back.linear() * normal).cast<float>();
    cloud->push_back(point);
  }
  return cloud;
}

} // namespace

void
addWalls(FloorPlan& plan, const std::vector<Eigen::Vector2d>& corners)
{
  for (std::size_t i = 1; i < corners.size(); ++i)
    plan.push_back({corners[i - 1], corners[i]});
}

void
addRectangle(FloorPlan& plan, double x0, double z0, double x1, double z1)
{
  addWalls(plan, {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}, {x0, z0}});
}

FloorPlan
makeRoomPlan()
{
  FloorPlan plan;
  addRectangle(plan, 0, 0, 9, 7);
  addRectangle(plan, 7.8, 2.1, 9, 4);
  addRectangle(plan, 4.2, 3.1, 4.6, 3.5);
  addWalls(plan, {{0, 5.2}, {1.1, 5.2}, {1.1, 7}});
  return plan;
}

FloorPlan
makeCornerPlan()
{
  FloorPlan plan;
  addWalls(plan, {{-1, -2},  {-1, 1},   {-1.4, 1},  {-1.4, 2},  {-1, 2},     {-1, 7},
                  {-1.4, 7}, {-1.4, 8}, {-1, 8},    {-1, 16},   {4, 16},     {4, 16.5},
                  {5, 16.5}, {5, 16},   {11, 16},   {11, 14},   {8, 14},     {8, 13.6},
                  {7, 13.6}, {7, 14},   {1, 14},    {1, 10.5},  {1.4, 10.5}, {1.4, 9.5},
                  {1, 9.5},  {1, 4.5},  {1.3, 4.5}, {1.3, 3.3}, {1, 3.3},    {1, -2},
                  {-1, -2}});
  return plan;
}

FloorPlan
makeLoopPlan()
{
  FloorPlan plan;
  addWalls(plan, {{0, 0},    {3, 0},      {3, -0.4},   {4, -0.4}, {4, 0},   {14, 0},
                  {14, 4.2}, {14.4, 4.2}, {14.4, 5.2}, {14, 5.2}, {14, 10}, {9, 10},
                  {9, 10.5}, {7.8, 10.5}, {7.8, 10},   {0, 10},   {0, 3.1}, {-0.3, 3.1},
                  {-0.3, 2}, {0, 2},      {0, 0}});
  addWalls(plan,
           {{2, 2},
            {7, 2},
            {7, 2.4},
            {8.2, 2.4},
            {8.2, 2},
            {12, 2},
            {12, 8},
            {5, 8},
            {5, 7.5},
            {4, 7.5},
            {4, 8},
            {2, 8},
            {2, 2}});
  return plan;
}

FloorPlan
makeBareCorridorPlan()
{
  return {{{-1, -100}, {-1, 200}}, {{1, -100}, {1, 200}}};
}

FloorPlan
makeAlikeRoomsPlan(int rooms)
{
  FloorPlan plan;
  for (int i = 0; i < rooms; ++i) {
    const double z = 4 * i;
    addWalls(plan,
             {{1, z + 1.4}, {1, z}, {5, z}, {5, z + 4}, {1, z + 4}, {1, z + 2.6}});
  }
  addWalls(plan, {{1, 0}, {-1, 0}, {-1, 4.0 * rooms}, {1, 4.0 * rooms}});
  return plan;
}

FloorPlan
makeParallelCorridorsPlan()
{
  FloorPlan plan;
  addRectangle(plan, 0, 0, 8.2, 22);
  addRectangle(plan, 2, 2, 2.2, 20);
  addRectangle(plan, 4.2, 2, 6.2, 20);
  return plan;
}

FloorPlan
makeCombPlan()
{
  FloorPlan plan;
  for (int i = -6; i < 20; ++i)
    for (const double side : {-1.0, 1.0}) {
      const double z = 2 * i;
      const double back = 1.3 * side;
      addWalls(
          plan,
          {{side, z}, {side, z + 1.2}, {back, z + 1.2}, {back, z + 2}, {side, z + 2}});
    }
  return plan;
}

std::vector<PlanarPose>
pathThrough(const std::vector<Eigen::Vector2d>& corners, double step)
{
  std::vector<PlanarPose> path;
  double to_go = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d leg = corners[i] - corners[i - 1];
    const Eigen::Vector2d way = leg.normalized();
    for (; to_go <= leg.norm(); to_go += step) {
      const Eigen::Vector2d place = corners[i - 1] + to_go * way;
      path.push_back({place[0], place[1], std::atan2(way[0], way[1])});
    }
    to_go -= leg.norm();
  }
  return path;
}

std::vector<PlanarPose>
pathRound(const Eigen::Vector2d& middle, const Eigen::Vector2d& radii, int poses)
{
  std::vector<PlanarPose> path;
  for (int i = 0; i < poses; ++i) {
    const double angle = 2 * M_PI * i / poses;
    const Eigen::Vector2d way(radii[0] * std::cos(angle), -radii[1] * std::sin(angle));
    path.push_back({middle[0] + radii[0] * std::sin(angle),
                    middle[1] + radii[1] * std::cos(angle),
                    std::atan2(way[0], way[1])});
  }
  return path;
}

PosedClouds
scanAlong(const FloorPlan& plan,
          const std::vector<PlanarPose>& path,
          const LaserSettings& laser,
          std::uint64_t seed)
{
  Random random(seed);
  PosedClouds map;
  map.poses = path;
  for (const PlanarPose& pose : path)
    map.clouds.push_back(scanFrom(plan, pose, laser, random));
  return map;
}

std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& path, const Drift& drift, std::uint64_t seed)
{
  Random random(seed);
  std::vector<PlanarPose> odometry{path.front()};
  for (std::size_t t = 1; t < path.size(); ++t) {
    PlanarAction action = actionBetween(path[t - 1], path[t]);
    const double sigma = drift.length_per_metre * std::hypot(action.dx, action.dz);
    action.dx += sigma * random.normal();
    action.dz += sigma * random.normal();
    action.dtheta += drift.bias + drift.turn * random.normal();
    odometry.push_back(moved(odometry.back(), action));
  }
  return odometry;
}

double
rmsError(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& truth)
{
  double sum = 0;
  for (std::size_t i = 0; i < poses.size(); ++i)
    sum += (placeOf(poses[i]) - placeOf(truth[i])).squaredNorm();
  return std::sqrt(sum / static_cast<double>(poses.size()));
}

World
makeRoomWorld(std::uint64_t seed)
{
  return {"room",
          scanAlong(makeRoomPlan(), pathRound({4.5, 3.5}, {2.6, 2.2}, 36), {}, seed)};
}

World
makeCornerWorld(std::uint64_t seed)
{
  return {
      "corner",
      scanAlong(
          makeCornerPlan(), pathThrough({{0, -1}, {0, 15}, {9.5, 15}}, 0.6), {}, seed)};
}

World
makeLoopWorld(std::uint64_t seed)
{
  return {
      "loop",
      scanAlong(makeLoopPlan(),
                pathThrough({{1, 1}, {1, 9}, {13, 9}, {13, 1}, {1, 1}, {1, 5}}, 0.6),
                {},
                seed)};
}

World
makeAlikeRoomsWorld(std::uint64_t seed)
{
  constexpr int rooms = 4;
  std::vector<Eigen::Vector2d> corners{{0, 0.6}};
  for (int i = 0; i < rooms; ++i)
    for (const double x : {0.0, 3.5, 0.1})
      corners.emplace_back(x, 4 * i + 2);
  corners.emplace_back(0, 4 * rooms - 0.5);
  return {"alike rooms",
          scanAlong(makeAlikeRoomsPlan(rooms), pathThrough(corners, 0.7), {}, seed)};
}

World
makeParallelCorridorsWorld(std::uint64_t seed)
{
  return {"parallel corridors",
          scanAlong(makeParallelCorridorsPlan(),
                    pathThrough({{1, 1}, {1, 21}, {3.2, 21}, {3.2, 1}, {3.2, 8}}, 0.9),
                    {},
                    seed)};
}

World
makeCombWorld(std::uint64_t seed)
{
  return {"comb",
          scanAlong(makeCombPlan(), pathThrough({{0, 0}, {0, 20}}, 0.5), {}, seed)};
}

} // namespace pcl::acmap::test
