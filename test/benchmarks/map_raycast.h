#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/trinocular_rig.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::bench {

/** \brief A view of a compact map: for each pixel the colour of the first chart that
 * its ray intersects. */
struct RaycastImage {
  std::vector<std::uint8_t> rgb;      ///< 3 per pixel, in row-major order from the top
  std::vector<std::uint8_t> is_known; ///< one per pixel: a texel with colour was hit
};

RaycastImage
castMap(const CompactMap& map,
        const TrinocularRig& rig,
        const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap::bench
