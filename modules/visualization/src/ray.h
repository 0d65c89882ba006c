#pragma once

#include "map_faces.h"

#include <limits>
#include <optional>

namespace pcl::acmap {

/** \brief First intersection of a ray with a plane. */
struct RayHit {
  std::size_t plane;
  double distance; ///< as a multiple of the direction
};

/** \param[in] fronts_only ignores faces that face away from the eye */
std::optional<RayHit>
firstHit(const std::vector<MapFaces>& faces,
         const Eigen::Vector3d& eye,
         const Eigen::Vector3d& direction,
         bool fronts_only);

} // namespace pcl::acmap
