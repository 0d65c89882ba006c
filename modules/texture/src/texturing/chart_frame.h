#pragma once

#include <pcl/core/compact_map.h>

#include <optional>

namespace pcl::acmap::texturing {

/** Texel grid of a polygon: its smallest bounding rectangle along one of its edges.
 * Seen from the side of the normal, u points right and v points down. */
struct ChartGrid {
  Eigen::Vector3d origin, texel_u, texel_v; ///< as in \ref TextureChart
  double columns, rows;                     ///< integral, possibly too large for an int
};

/** \return nothing if the polygon has no area, or the polygon or its plane is
 * invalid */
std::optional<ChartGrid>
gridOf(const PlanePatch& plane, std::size_t polygon, double texel_size);

/** Charts of a polygon, without colours: several tiles if it has more texels than a
 * texture may have.
 * \param[in] maximum maximum number of texels per side */
std::vector<TextureChart>
chartsOf(const ChartGrid& grid,
         std::size_t plane_number,
         std::size_t polygon,
         int maximum);

/** Projection of a point onto the plane, in texels of a chart: (0, 0) is the outer
 * corner of the first texel. */
inline Eigen::Vector2d
placeOn(const TextureChart& chart, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d way = point - chart.origin;
  return {way.dot(chart.texel_u) / chart.texel_u.squaredNorm(),
          way.dot(chart.texel_v) / chart.texel_v.squaredNorm()};
}

/** Centre of a texel in the map frame. */
inline Eigen::Vector3d
middleOf(const TextureChart& chart, double column, double row)
{
  return chart.origin + (column + 0.5) * chart.texel_u + (row + 0.5) * chart.texel_v;
}

} // namespace pcl::acmap::texturing
