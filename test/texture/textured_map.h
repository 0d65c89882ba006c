#pragma once

#include <pcl/core/compact_map.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A small room far from the origin: a wall with a hole (chart 0), an L-shaped
 * floor on two tiles (charts 1 and 2), a ceiling without a chart. Colours change
 * slowly; some texels are filled, some unknown.
 * \param[in] place position of the room, metres */
CompactMap
makeTexturedMap(const Eigen::Vector3d& place = Eigen::Vector3d::Zero());

/** \brief Area of the polygons of each chart, and of those without one, square
 * metres. */
std::vector<double>
areasOf(const CompactMap& map);

/** \brief A triangle read by another program, in the frame of the map. */
struct ReadTriangle {
  Eigen::Vector3d corners[3];
  Eigen::Vector2d places[3]; ///< texture coordinates, with the origin top left
  std::size_t chart;         ///< according to its material; no_chart without a texture
};

constexpr std::size_t no_chart = static_cast<std::size_t>(-1);

/** \brief Checks areas, orientation of faces, and that texture coordinates refer to the
 * texels at these positions. */
void
expectSurfaces(const std::vector<ReadTriangle>& triangles, const CompactMap& map);

} // namespace pcl::acmap::test
