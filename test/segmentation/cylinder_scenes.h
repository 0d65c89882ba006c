#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::acmap::test {

/** \brief A cylinder of a scene, metres. */
struct SceneCylinder {
  Eigen::Vector3d point;
  Eigen::Vector3d axis; ///< unit
  double radius = 0;
};

/** \brief One view of a depth camera at the origin, x right, y down, z forward; in
 * metres, with noise along the rays. */
struct CylinderView {
  PointCloud<PointXYZ>::Ptr cloud{new PointCloud<PointXYZ>};
  std::vector<SceneCylinder> cylinders;
  std::vector<std::int32_t> truth; ///< cylinder of each point, -1 for none
};

/** \brief Three columns, by default with radii of 5, 15 and 30 cm, turned and placed at
 * random, before two walls and a floor: 66,000 points.
 * \param[in] sigma of the noise, metres
 * \param[in] radii metres; in random order from left to right */
CylinderView
seeColumns(double sigma,
           std::uint64_t seed,
           std::vector<double> radii = {0.05, 0.15, 0.3});

/** \brief Its two walls and its floor; a point p is before one if plane . (p, 1) > 0. */
std::vector<Eigen::Vector4d>
planesOfRoom();

/** \brief The same room without any column. */
CylinderView
seeEmptyRoom(double sigma, std::uint64_t seed);

/** \brief A wall of 6 m at 4 m, and the floor before it.
 * \param[in] depth of the wall beyond 4 m at a place x, metres */
CylinderView
seeWall(const std::function<double(double)>& depth, double sigma, std::uint64_t seed);

/** \brief A wall of radius 10 m, bent towards the camera or away from it. */
CylinderView
seeRoundWall(bool is_hollow, double sigma, std::uint64_t seed);

} // namespace pcl::acmap::test
