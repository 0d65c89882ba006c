#pragma once

#include <pcl/core/report.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace pcl {

/** \brief Report of MapLevelling on its last run. \ingroup mapping */
struct MapLevellingReport : Report {
  std::size_t observations = 0, points = 0, invalid_points = 0;
  bool found = false; ///< Is the up direction given, or shown by the surfaces?
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();   ///< in the given map frame
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY(); ///< the up axis of the level map
  double tilt = 0;        ///< radians by which the map was turned
  double uncertainty = 0; ///< of the up direction, one standard deviation, radians
  /** \brief Share of the surface that is horizontal or vertical, to within 10 degrees. */
  double share = 0;
  std::string reason; ///< one line: what determined the up direction
};

} // namespace pcl
