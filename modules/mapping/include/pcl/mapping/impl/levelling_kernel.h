#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/impl/up_direction.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/map_levelling_types.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief What levelling needs of an observation; sensor frame, metres. */
struct ObservedSurface {
  std::vector<FacingArea> facings; ///< normals, combined within some degrees
  std::size_t points = 0, invalid_points = 0;
  double weight = 0;   ///< of the finite points
  double in_front = 0; ///< weight of the points within 65 degrees of the z axis
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();     ///< of weighted points
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(); ///< of weighted points
};

/** \brief Sums up an observation.
 * \param[in] points sensor frame, metres; may be NaN
 * \param[in] normals of the same points, NaN where there is none; empty: none
 * \param[in] weights one per point; empty: 1 each */
ACMAP_EXPORT ObservedSurface
observedSurface(const PointView& points,
                const PointView& normals,
                const std::vector<float>& weights);

/** \brief Finds the up direction of a map.
 * \param[in] poses T_map_sensor, one per observation
 * \param[in] given the up direction, if it is known
 * \param[out] report all but counts of points
 * \return the rotation from the given map frame to the level one */
ACMAP_EXPORT Eigen::Quaterniond
levelMap(const std::vector<ObservedSurface>& observations,
         const std::vector<Eigen::Isometry3d>& poses,
         const std::optional<Eigen::Vector3d>& given,
         MapLevellingReport& report);

/** \brief The vertical for a class whose poses move perpendicularly to it.
 * \param[out] report its up direction and where it is from; a remark if it was not found
 * \return the up direction: given, found, or the axis that is expected */
ACMAP_EXPORT Eigen::Vector3d
verticalOf(const std::vector<ObservedSurface>& observations,
           const std::vector<Eigen::Isometry3d>& poses,
           const std::optional<Eigen::Vector3d>& given,
           EntropyRectificationReport& report);

} // namespace pcl::acmap
