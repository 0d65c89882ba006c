#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/triangle_mesh.h>

#include <vector>

namespace pcl::acmap {

/** \brief A polygon, or the part of it that a chart covers, as triangles that face where
 * the plane's normal points. */
struct ChartSurface {
  static constexpr std::size_t no_chart = static_cast<std::size_t>(-1);

  std::size_t plane = 0;
  std::size_t chart = no_chart;
  std::vector<Eigen::Vector3d> points;

  /** \brief Where each point lies in the chart: columns and rows from the outer corner of
   * texel (0, 0); zero without a chart. */
  std::vector<Eigen::Vector2d> places;
  std::vector<TriangleMesh::Triangle> triangles;
};

/** \brief The surfaces of all charts, in their order, then the polygons without a chart.
 * Those without an area are there, without triangles.
 * \param[in] map that saveMapFile took: no point of it is passed over
 * \throws BadArgumentException when a normal is zero or not finite */
std::vector<ChartSurface>
surfacesOf(const CompactMap& map);

} // namespace pcl::acmap
