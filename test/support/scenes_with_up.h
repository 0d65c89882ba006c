#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Points of a scene in a frame whose up direction is known. Metres. */
struct SceneWithUp {
  std::string name;
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
};

/** \brief Rooms with furniture, with and without a ceiling, a hall, a facade with its
 * pavement, roofs seen from the air and a crate, in frames that are level and turned about z
 * by random angles, as phones and scanners have them, or aligned with the walls, as drawings
 * have them. */
std::vector<SceneWithUp>
scenesWithUp(std::uint64_t seed);

/** \brief A furnished room of which the floor and the walls were seen, turned about z. */
SceneWithUp
turnedRoomWithoutCeiling(std::uint64_t seed);

/** \brief Rotations that turn z to each of the six axes. */
std::vector<Eigen::Matrix3d>
turnsToAxes();

} // namespace pcl::acmap::test
