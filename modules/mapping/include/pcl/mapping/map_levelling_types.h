#pragma once

#include <pcl/core/fields.h>
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

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MapLevellingReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"found"}, report.found);
  visit({"up"}, report.up);
  visit({"axis"}, report.axis);
  visit({"tilt", "rad"}, report.tilt);
  visit({"uncertainty", "rad"}, report.uncertainty);
  visit({"share"}, report.share);
  visit({"reason"}, report.reason);
}

} // namespace pcl
