#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/cloud_statement.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief The shift of a map, metres: what is stated, else the whole kilometres of the
 * median along the axes along which nine tenths of the places are beyond 10 km. Places that are not finite or
 * (0, 0, 0) do not count.
 * \param[in] places such as those of the sensors, metres */
ACMAP_EXPORT Eigen::Vector3d
shiftOfPlaces(const std::vector<Eigen::Vector3d>& places,
              const std::optional<Eigen::Vector3d>& stated);

/** \brief "665000, 5648000, 0". */
ACMAP_EXPORT std::string
shiftText(const Eigen::Vector3d& shift);

} // namespace pcl::acmap
