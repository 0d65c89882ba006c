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

/** \brief Parameters of a laser on the floor. */
struct LaserSettings {
  int beams = 240;      ///< over 360 degrees
  double reach = 12;    ///< metres
  double noise = 0.005; ///< metres, along a beam
};

/** \brief Odometry noise: standard deviations, and a bias of every step. */
struct Drift {
  double length_per_metre = 0.03; ///< metres, in both directions
  double turn = 0.006;            ///< radians per step
  double bias = 0.002;            ///< radians per step
};

/** \brief The noise for the rooms with drifting poses. */
constexpr Drift drift{0.06, 0.012, 0.004};

/** \brief Adds walls around a rectangle. */
void
addRectangle(FloorPlan& plan, double x0, double z0, double x1, double z1);

/** \brief Adds walls between consecutive corners. */
void
addWalls(FloorPlan& plan, const std::vector<Eigen::Vector2d>& corners);

/** \brief A room of 9 x 7 m with a cupboard and pillars. */
FloorPlan
makeRoomPlan();

/** \brief Two corridors of 2 m, 18 and 12 m long, at a right angle, with niches. */
FloorPlan
makeCornerPlan();

/** \brief A corridor around a block: 14 x 10 m outside, 2 m wide, with niches. */
FloorPlan
makeLoopPlan();

/** \brief Two plain walls along z, 2 m apart, whose ends are out of sight. */
FloorPlan
makeBareCorridorPlan();

/** \brief Equal rooms of 4 x 4 m side by side along a corridor. */
FloorPlan
makeAlikeRoomsPlan(int rooms);

/** \brief Two corridors of 2 m side by side with a thin wall in between, connected at
 * their ends. */
FloorPlan
makeParallelCorridorsPlan();

/** \brief A corridor with equal niches every 2 m. */
FloorPlan
makeCombPlan();

/** \brief A path through corners with steps of equal length, facing in the direction of
 * motion. */
std::vector<PlanarPose>
pathThrough(const std::vector<Eigen::Vector2d>& corners, double step);

/** \brief One turn along an ellipse. */
std::vector<PlanarPose>
pathRound(const Eigen::Vector2d& middle, const Eigen::Vector2d& radii, int poses);

/** \brief Simulated laser scans from each pose, with the normals of the walls. */
PosedClouds
scanAlong(const FloorPlan& plan,
          const std::vector<PlanarPose>& path,
          const LaserSettings& laser,
          std::uint64_t seed);

/** \brief The path with odometry noise; the first pose is correct. */
std::vector<PlanarPose>
drifted(const std::vector<PlanarPose>& path, const Drift& drift, std::uint64_t seed);

/** \brief RMS distance of the positions, metres; the first poses are equal. */
double
rmsError(const std::vector<PlanarPose>& poses, const std::vector<PlanarPose>& truth);

/** \brief A building and its observations. */
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
