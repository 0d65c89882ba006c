#pragma once

#include <pcl/core/scratch_memory.h>

#include <array>
#include <cstdint>

namespace pcl {

/** \brief Triangles as flat index triples into a separate point cloud.
 *
 * A `pcl::PolygonMesh` has one heap-allocated `pcl::Vertices` per face, which takes
 * five times the memory. Stages exchange this class instead and convert at the
 * interface. \ingroup core */
struct TriangleMesh {
  using Triangle = std::array<std::int32_t, 3>;
  using Triangles = LargeVector<Triangle>;

  /** \brief Corners, counter-clockwise seen from the front side of the face. */
  Triangles triangles;

  /** \brief For each triangle the recursion depth of the divide step whose wall created
   * it (0 = first splitting plane, Fig. 5); empty if it was not requested. Triangles of
   * the final sequential passes have the value \ref no_wall. */
  LargeVector<std::uint8_t> wall_depth;

  static constexpr std::uint8_t no_wall = 255;
};

} // namespace pcl
