#pragma once

#include "map_faces.h"

#include <limits>
#include <optional>

namespace pcl::acmap {

/** \brief Where a ray first meets a plane. */
struct RayHit {
  std::size_t plane;
  double distance; ///< in lengths of the direction
};

/** \param[in] fronts_only lets the ray pass through faces that look away from the eye */
std::optional<RayHit>
firstHit(const std::vector<MapFaces>& faces,
         const Eigen::Vector3d& eye,
         const Eigen::Vector3d& direction,
         bool fronts_only);

} // namespace pcl::acmap
