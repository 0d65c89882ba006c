#pragma once

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/simulation/simulated_scene.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief Observations of a scene, with the truth; all in the frame of the first
 * camera, metres. */
struct SeenRoom {
  PointCloud<PointXYZRGBNormalView>::Ptr cloud;
  std::vector<Eigen::Vector3f> viewpoints;
  std::vector<std::int32_t> truth; ///< index in planes of each point; -1 for none
  std::vector<TruthPlane> planes;
};

/** \brief A camera with few pixels in an empty scene, with constant noise along the
 * rays in metres. */
SimulatedScene
makeEmptyScene(double noise);

/** \brief A corner of a room at 3 m: far wall, left wall and floor. */
SimulatedScene
makeRoomCorner(double noise);

/** \brief A wall with a door that is recessed by \a depth, a floor, and a box in front
 * of the wall. */
SimulatedScene
makeRoomWithDoor(double noise, double depth);

/** \brief Simulates all views. */
SeenRoom
see(const SimulatedScene& scene, std::uint64_t seed);

/** \brief Simulates all views with four times the pixels, as many as a real view
 * has. */
SeenRoom
seeSharply(SimulatedScene scene);

/** \brief The true plane with this name; the number of planes if there is none. */
std::int32_t
planeNamed(const SeenRoom& room, const std::string& name);

/** \brief Distance from a point to the nearest rectangle of a plane, metres. */
double
distanceTo(const TruthPlane& plane, const Eigen::Vector3d& place);

} // namespace pcl::acmap::test
