#pragma once

#include "naive_entropy.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief A wall of a floor plan, seen from both sides. */
struct PlanWall {
  Eigen::Vector2d from, to; ///< x, z, metres
};

using FloorPlan = std::vector<PlanWall>;

/** \brief How a laser on the floor looks about. */
struct LaserSettings {
  int beams = 240;      ///< all round
  double reach = 12;    ///< metres
  double noise = 0.005; ///< metres, along a beam
};

/** \brief How far odometry is off: one standard deviation, and what every step has. */
struct Drift {
  double length_per_metre = 0.03; ///< metres, along and across
  double turn = 0.006;            ///< radians a step
  double bias = 0.002;            ///< radians a step
};

/** \brief That of the rooms that come drifted. */
constexpr Drift drift{0.06, 0.012, 0.004};

/** \brief Walls round a rectangle. */
void
addRectangle(FloorPlan& plan, double x0, double z0, double x1, double z1);

/** \brief Walls through corners, in turn. */
void
addWalls(FloorPlan& plan, const std::vector<Eigen::Vector2d>& corners);

/** \brief A room of 9 x 7 m with a cupboard and pillars. */
FloorPlan
makeRoomPlan();

/** \brief Two corridors of 2 m, 18 and 12 m long, at a right angle, with niches. */
FloorPlan
makeCornerPlan();

/** \brief A corridor round a block: 14 x 10 m outside, 2 m wide, with niches. */
FloorPlan
makeLoopPlan();

/** \brief Two plain walls along z, 2 m apart, without ends in sight. */
FloorPlan
makeBareCorridorPlan();

/** \brief Rooms of 4 x 4 m, each like the others, side by side along a corridor. */
FloorPlan
makeAlikeRoomsPlan(int rooms);

/** \brief Two corridors of 2 m side by side, a thin wall between, joined at their ends. */
FloorPlan
makeParallelCorridorsPlan();

/** \brief A corridor with a niche every 2 m, each like the others. */
FloorPlan
makeCombPlan();

/** \brief A path through corners with steps of one length, looking where it goes. */
std::vector<PlanarPose>
pathThrough(const std::vector<Eigen::Vector2d>& corners, double step);

/** \brief An ellipse about a middle, once round. */
std::vector<PlanarPose>
pathRound(const Eigen::Vector2d& middle, const Eigen::Vector2d& radii, int poses);

/** \brief What a laser sees from each pose; normals are the walls', towards it. */
PosedClouds
scanAlong(const FloorPlan& plan,
          const std::vector<PlanarPose>& path,
          const LaserSettings& laser,
          std::uint64_t seed);

/** \brief The path as odometry has it; the first pose is right. */
std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& path, const Drift& drift, std::uint64_t seed);

/** \brief Root mean square distance of places, metres; the first poses are equal. */
double
rmsError(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& truth);

/** \brief A building and what was seen of it. */
struct World {
  const char* name;
  PosedClouds truth;
};

World
makeRoomWorld(std::uint64_t seed);

World
makeCornerWorld(std::uint64_t seed);

World
makeLoopWorld(std::uint64_t seed);

World
makeAlikeRoomsWorld(std::uint64_t seed);

World
makeParallelCorridorsWorld(std::uint64_t seed);

World
makeCombWorld(std::uint64_t seed);

} // namespace pcl::acmap::test
