#pragma once

#include <pcl/core/compact_map.h>

#include <string>
#include <vector>

namespace pcl::acmap::test {

/** \brief A small room far out: a wall with a hole (chart 0), a floor in the shape of an
 * L on two tiles (charts 1 and 2), a ceiling without a chart. Colours change slowly;
 * some texels are filled, some not known.
 * \param[in] place of the room, metres */
CompactMap
makeTexturedMap(const Eigen::Vector3d& place = Eigen::Vector3d::Zero());

/** \brief Square metres of the polygons under each chart, then of those without one. */
std::vector<double>
areasOf(const CompactMap& map);

/** \brief A triangle that another program read, in the map's frame. */
struct ReadTriangle {
  Eigen::Vector3d corners[3];
  Eigen::Vector2d places[3]; ///< texture coordinates from the top left
  std::size_t chart;         ///< as its material says; no_chart without a texture
};

constexpr std::size_t no_chart = static_cast<std::size_t>(-1);

/** \brief Expects the areas, that faces look where normals do, and that texture
 * coordinates lead to the texels that lie there. */
void
expectSurfaces(const std::vector<ReadTriangle>& triangles, const CompactMap& map);

} // namespace pcl::acmap::test
