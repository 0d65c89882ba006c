#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/map_entropy_types.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief Observations with their poses (x, z, theta). */
struct PosedClouds {
  std::vector<PointCloud<PointNormal>::Ptr> clouds;
  std::vector<PlanarPose> poses;
};

/** \brief Parameters of the naive entropy. */
struct NaiveEntropySettings {
  double bin = 0.1;
  double sigma = 0.1;
  double mu = 0.5;
  bool directions = false;
  bool splines = false; ///< distribute each point by a B-spline instead of using one
                        ///< bin
};

/** \brief Eq. 3 with maps and plain loops over all points; shares no code with the
 * library. */
MapEntropyTerms
naiveEntropy(const PosedClouds& map, const NaiveEntropySettings& settings);

/** \brief Views of a room of 6 x 4 m with a box, from poses along a curve; points with
 * normals towards the sensor, 5 mm noise, some of them on the floor.
 * \param[in] points of each view */
PosedClouds
makeRoomViews(std::size_t views, std::size_t points, std::uint64_t seed);

/** \brief One wall along x of a given \a thickness; each side is seen by a separate
 * observation. */
PosedClouds
makeThinWall(double thickness);

} // namespace pcl::acmap::test
