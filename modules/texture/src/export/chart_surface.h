#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/triangle_mesh.h>

#include <vector>

namespace pcl::acmap {

/** \brief A polygon, or the part of it that a chart covers, as triangles whose front is
 * the side to which the normal of the plane points; or a facet of a cylinder; or a whole
 * cylinder with its picture. */
struct ChartSurface {
  static constexpr std::size_t no_chart = static_cast<std::size_t>(-1);

  /** \brief Number of its plane, or the number of planes plus that of its cylinder; of a
   * side of a box, the number of planes and cylinders plus that of the box. */
  std::size_t plane = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< of length 1
  std::size_t chart = no_chart; ///< number of the picture in \ref picturesOf
  std::vector<Eigen::Vector3d> points;

  /** \brief Position of each point in the chart, in columns and rows from the outer
   * corner of texel (0, 0); zero if there is no chart. */
  std::vector<Eigen::Vector2d> places;
  TriangleMesh::Triangles triangles;
};

/** \brief The surfaces of all charts in their order, followed by the polygons without a
 * chart, and by the cylinders: in one piece if they have colours, else their facets. A surface without area is included, but has no
 * triangles.
 * \param[in] map one that saveMapFile accepts: none of its points is skipped
 * \throws BadArgumentException when a normal is zero or not finite */
std::vector<ChartSurface>
surfacesOf(const CompactMap& map);

/** \brief The proposed polygons of all planes, in their order, and the free sides of the
 * boxes.
 * \throws BadArgumentException when a normal is zero or not finite */
std::vector<ChartSurface>
proposedSurfacesOf(const CompactMap& map);

/** \brief For each texel of an image, is its centre inside one of the triangles of a
 * surface? */
std::vector<bool>
coverOf(const ChartSurface& surface, const RgbImage& image);

} // namespace pcl::acmap
