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

/** \brief How the naive entropy goes. */
struct NaiveSettings {
  double bin = 0.1;
  double sigma = 0.1;
  double mu = 0.5;
  bool directions = false;
  bool splines = false; ///< each point by a B-spline instead of into its bin
};

/** \brief Eq. 3 by maps and plain loops over every point; no code is shared with the
 * library. */
MapEntropyTerms
naiveEntropy(const PosedClouds& map, const NaiveSettings& settings);

/** \brief Views of one room of 6 x 4 m with a box in it, from poses along a curve;
 * points with normals towards the sensor, 5 mm of noise, some of them on the floor.
 * \param[in] points of each view */
PosedClouds
makeRoomViews(std::size_t views, std::size_t points, std::uint64_t seed);

/** \brief One wall along x, \a thickness apart its two sides, each seen by an
 * observation of its own. */
PosedClouds
makeThinWall(double thickness);

} // namespace pcl::acmap::test
