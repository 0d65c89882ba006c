#pragma once

#include "clustering_runs.h"

#include <pcl/core/point_types.h>
#include <pcl/simulation/simulated_scene.h>

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

/** \brief What came out of the whole way: consolidation, mesh, votes, planes. */
struct RoomPlanes : Clustered {
  std::vector<std::int32_t> truth; ///< of each patch, where most of its points are of
  double voxel = 0;                ///< metres
};

/** \param[in] set what is not to stay at its default */
RoomPlanes
findPlanes(
    const SeenRoom& room,
    const std::function<void(PlaneHypothesisClustering<PointXYZRGBNormalView>&)>& set =
        [](auto&) {});

} // namespace pcl::acmap::test
