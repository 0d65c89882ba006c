#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/core/random.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Part of the recording during which a piece of furniture is in its place. */
enum class WallTime { Always, FirstHalf, SecondHalf };

/** \brief A straight surface in the plan of a building, seen from both sides. */
struct BuildingWall {
  Eigen::Vector2d from, to; ///< x, z, metres
  WallTime time = WallTime::Always;
};

/** \brief A generated building and the trajectory of a robot in it. */
struct Building {
  std::vector<BuildingWall> walls;
  std::vector<PlanarPose> path; ///< one pose per scan
  double reach = 20;            ///< metres, maximum range of the laser
};

/** \brief A kind of building, from which each seed makes another one. */
struct BuildingKind {
  std::string name;
  Building (*make)(Random& random);
};

/** \brief Kinds that were not looked at while the guard was developed. */
const std::vector<BuildingKind>&
buildingKinds();

/** \brief Kinds with places that look alike, or change; made for the verdict. */
const std::vector<BuildingKind>&
lookalikeKinds();

/** \brief Adds boxes beside the path of the robot, 0.3 to 1 m wide.
 * \param[in] moves the boxes are in their places for one half of the recording only */
void
addFurniture(Building& building, int boxes, bool moves, Random& random);

} // namespace pcl::acmap::bench
