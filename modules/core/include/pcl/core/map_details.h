#pragma once

#include <pcl/core/triangle_mesh.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief What lies on no surface of a map: the mesh of these points, simplified.
 * \ingroup core */
struct MapDetails {
  std::vector<Eigen::Vector3f> vertices;           ///< metres, in the map frame
  std::vector<std::array<std::uint8_t, 3>> colors; ///< of the input, one per vertex
  TriangleMesh mesh;
};

} // namespace pcl
