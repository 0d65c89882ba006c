#pragma once

#include <pcl/core/export.h>
#include <pcl/core/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::acmap {

/** \brief For each vertex of a mesh the vertices with which it shares an edge, in
 * ascending order. \ingroup core */
class VertexNeighbours {
public:
  /** \brief The neighbours of one vertex, for range-based loops. */
  struct Range {
    const std::int32_t* first;
    const std::int32_t* last;

    const std::int32_t*
    begin() const
    {
      return first;
    }

    const std::int32_t*
    end() const
    {
      return last;
    }

    std::size_t
    size() const
    {
      return static_cast<std::size_t>(last - first);
    }
  };

  VertexNeighbours() = default;

  /** \param[in] vertices number of vertices of the mesh; the indices of all corners are
   * below it
   * \param[in] triangles the faces of the mesh
   * \throws nothing */
  ACMAP_EXPORT
  VertexNeighbours(std::size_t vertices, const TriangleMesh::Triangles& triangles);

  /** \param[in] first index of the first neighbour of each vertex, and the number of
   * neighbours
   * \param[in] others the neighbours of all vertices */
  VertexNeighbours(LargeVector<std::size_t> first, LargeVector<std::int32_t> others)
  : first_(std::move(first))
  , others_(std::move(others))
  {}

  std::size_t
  vertices() const
  {
    return first_.empty() ? 0 : first_.size() - 1;
  }

  Range
  operator[](std::size_t vertex) const
  {
    return {others_.data() + first_[vertex], others_.data() + first_[vertex + 1]};
  }

  /** \brief Total number of neighbours: twice the number of edges. */
  std::size_t
  size() const
  {
    return others_.size();
  }

private:
  LargeVector<std::size_t> first_;
  LargeVector<std::int32_t> others_;
};

} // namespace pcl::acmap
