#pragma once

#include "cylinder_scenes.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** \brief How the points of a \ref HalfSeenRoom are made. */
struct HalfSeenSettings {
  double sigma = 0.01; ///< metres
  double density =
      1700; ///< points per square metre of wall; columns have 2.4 times as many
  bool is_along_rays = false; ///< is the noise along the rays, or across the surface?
  bool is_z_up = false;       ///< else y
  std::uint64_t seed = 0;
};

/** \brief A room as other programs give it: points at random places of a floor, two walls,
 * and one to three columns, of which only the side towards the sensor was seen. */
struct HalfSeenRoom {
  PointCloud<PointXYZ>::Ptr cloud{new PointCloud<PointXYZ>}; ///< without a sensor
  Eigen::Vector3f sensor = Eigen::Vector3f::Zero();
  std::vector<SceneCylinder> columns;
};

HalfSeenRoom
makeHalfSeenRoom(const HalfSeenSettings& settings);

} // namespace pcl::acmap::test
