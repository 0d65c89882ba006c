#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/trinocular_rig.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::bench {

/** \brief A view of a compact map: the colour of the first chart that each pixel's ray
 * meets. */
struct MapView {
  std::vector<std::uint8_t> rgb;      ///< 3 a pixel, rows from the top
  std::vector<std::uint8_t> is_known; ///< one a pixel: a texel with colour was met
};

MapView
castMap(const CompactMap& map,
        const TrinocularRig& rig,
        const Eigen::Isometry3d& T_map_camera);

} // namespace pcl::acmap::bench
