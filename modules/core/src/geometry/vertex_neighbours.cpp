#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/vertex_neighbours.h>

#include <algorithm>

namespace pcl::acmap {

VertexNeighbours::VertexNeighbours(std::size_t vertices,
                                   const TriangleMesh::Triangles& triangles)
{
  // an edge is found once in each of its triangles: duplicates are removed below
  LargeVector<std::size_t> begin(vertices + 1, 0);
  for (const TriangleMesh::Triangle& triangle : triangles)
    for (const std::int32_t corner : triangle)
      begin[static_cast<std::size_t>(corner) + 1] += 2;
  for (std::size_t v = 0; v < vertices; ++v)
    begin[v + 1] += begin[v];
  others_.resize(begin.back());
  LargeVector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const TriangleMesh::Triangle& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t step : {1, 2})
        others_[next[static_cast<std::size_t>(triangle[k])]++] =
            triangle[(k + step) % 3];

  first_.assign(vertices + 1, 0);
  parallelForChunks(vertices, [&](std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v) {
      const auto first = others_.begin() + static_cast<std::ptrdiff_t>(begin[v]);
      auto last = others_.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
      std::sort(first, last);
      last = std::remove(first, std::unique(first, last), static_cast<std::int32_t>(v));
      first_[v + 1] = static_cast<std::size_t>(last - first);
    }
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto first = others_.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    const auto size = static_cast<std::ptrdiff_t>(first_[v + 1]);
    std::copy(
        first, first + size, others_.begin() + static_cast<std::ptrdiff_t>(first_[v]));
    first_[v + 1] += first_[v];
  }
  others_.resize(first_.back());
  others_.shrink_to_fit();
}

} // namespace pcl::acmap
