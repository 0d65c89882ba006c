#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief Triangles as flat index triples into a point cloud that stands beside them.
 *
 * A `pcl::PolygonMesh` holds one heap-allocated `pcl::Vertices` a face, five times the
 * memory; stages pass this instead and convert at the border. \ingroup core
 */
struct TriangleMesh {
  using Triangle = std::array<std::int32_t, 3>;

  /** \brief Corners, counter-clockwise seen from the side the face looks to. */
  std::vector<Triangle> triangles;

  /** \brief For each triangle the depth of the divide step whose wall made it (0 = first
   * splitting plane, Fig. 5); empty where it was not asked for. Triangles of the last
   * sequential passes carry \ref no_wall. */
  std::vector<std::uint8_t> wall_depth;

  static constexpr std::uint8_t no_wall = 255;
};

} // namespace pcl
