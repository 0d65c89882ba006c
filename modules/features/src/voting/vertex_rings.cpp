#include "voting/vertex_rings.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap::voting {

VertexRings::VertexRings(const PointView& points,
                         const TriangleMesh::Triangles& triangles,
                         const LargeVector<Face>& faces)
{
  // an edge is found once in each of its triangles: duplicates are removed below
  LargeVector<std::size_t> next(points.size() + 1, 0);
  first_owned_.assign(points.size() + 1, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (faces[t].area > 0) {
      for (const std::int32_t corner : triangles[t])
        next[static_cast<std::size_t>(corner) + 1] += 2;
      ++first_owned_[static_cast<std::size_t>(triangles[t][0]) + 1];
    }
  for (std::size_t v = 0; v < points.size(); ++v) {
    next[v + 1] += next[v];
    first_owned_[v + 1] += first_owned_[v];
  }
  LargeVector<std::int32_t> others(next.back());
  owned_.resize(first_owned_.back());
  LargeVector<std::size_t> begin(next.begin(), next.end() - 1),
      owner(first_owned_.begin(), first_owned_.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (faces[t].area > 0) {
      for (int k = 0; k < 3; ++k)
        for (const int step : {1, 2})
          others[begin[static_cast<std::size_t>(triangles[t][k])]++] =
              triangles[t][(k + step) % 3];
      owned_[owner[static_cast<std::size_t>(triangles[t][0])]++] =
          static_cast<std::uint32_t>(t);
    }

  first_spoke_.assign(points.size() + 1, 0);
  parallelForChunks(points.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v) {
      const auto first = others.begin() + static_cast<std::ptrdiff_t>(next[v]);
      const auto last = others.begin() + static_cast<std::ptrdiff_t>(next[v + 1]);
      std::sort(first, last);
      first_spoke_[v + 1] = static_cast<std::size_t>(std::unique(first, last) - first);
    }
  });
  for (std::size_t v = 0; v < points.size(); ++v)
    first_spoke_[v + 1] += first_spoke_[v];
  spokes_.resize(first_spoke_.back());
  parallelForChunks(points.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v) {
      const Eigen::Vector3f place = points[v];
      for (std::size_t k = 0; k < first_spoke_[v + 1] - first_spoke_[v]; ++k) {
        const std::int32_t other = others[next[v] + k];
        spokes_[first_spoke_[v] + k] = {
            other, (points[static_cast<std::size_t>(other)] - place).norm()};
      }
    }
  });
  double sum = 0;
  for (const Spoke& spoke : spokes_)
    sum += spoke.length;
  mean_edge_ = spokes_.empty() ? 0 : sum / static_cast<double>(spokes_.size());
}

} // namespace pcl::acmap::voting
