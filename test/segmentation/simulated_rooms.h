#pragma once

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief What the sensor saw of a scene, with its truth; all in the frame of the first
 * camera, metres. */
struct SeenRoom {
  PointCloud<PointXYZRGBNormalView>::Ptr cloud;
  std::vector<Eigen::Vector3f> viewpoints;
  std::vector<std::int32_t> truth; ///< of each point, its place in planes; -1 for none
  std::vector<TruthPlane> planes;
};

/** \brief A camera of a few pixels in an empty scene; noise in metres along the ray,
 * everywhere the same. */
SimulatedScene
makeEmptyScene(double noise);

/** \brief A corner of a room from 3 m away: far wall, left wall and floor. */
SimulatedScene
makeRoomCorner(double noise);

/** \brief A wall with a door that lies \a depth behind it, floor, and a box before the wall.
 */
SimulatedScene
makeRoomWithDoor(double noise, double depth);

/** \brief All views. */
SeenRoom
see(const SimulatedScene& scene, std::uint64_t seed);

/** \brief All views with four times the pixels: as many points as a real view has. */
SeenRoom
seeSharply(SimulatedScene scene);

/** \brief The true plane of that name; the number of planes where there is none. */
std::int32_t
planeNamed(const SeenRoom& room, const std::string& name);

/** \brief Metres from a place to the nearest rectangle of a plane. */
double
distanceTo(const TruthPlane& plane, const Eigen::Vector3d& place);

} // namespace pcl::acmap::test
