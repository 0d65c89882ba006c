#pragma once

#include "mesh_checker.h"

#include <pcl/core/impl/disjoint_sets.h>

#include <map>
#include <numeric>

namespace pcl::acmap::test {

/** \brief An edge as its two vertices, the smaller index first. */
using Edge = std::pair<std::int32_t, std::int32_t>;

/** \brief A face that contains an edge. */
struct EdgeUse {
  std::size_t face;
  std::int32_t apex;
  bool forward; ///< the face traverses the edge from the smaller index to the larger
};

using EdgeMap = std::map<Edge, std::vector<EdgeUse>>;

inline Edge
makeEdge(std::int32_t a, std::int32_t b)
{
  return {std::min(a, b), std::max(a, b)};
}

/** \brief All edges with their faces; the vertices of a face must be distinct. */
inline EdgeMap
edgesOf(const Triangles& faces)
{
  EdgeMap edges;
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = faces[face][i];
      const std::int32_t b = faces[face][(i + 1) % 3];
      edges[makeEdge(a, b)].push_back({face, faces[face][(i + 2) % 3], a < b});
    }
  return edges;
}

using FaceSets = DisjointSets<std::size_t>;

inline std::vector<std::vector<std::size_t>>
facesAroundVertices(const Triangles& faces, std::size_t size)
{
  std::vector<std::vector<std::size_t>> around(size);
  for (std::size_t face = 0; face < faces.size(); ++face)
    for (const std::int32_t corner : faces[face])
      around[corner].push_back(face);
  return around;
}

/** \brief Number of fans at a vertex: sets of its faces that are connected through
 * edges at the vertex. */
inline std::size_t
countFans(const Triangles& faces,
          const std::vector<std::size_t>& around,
          std::int32_t vertex)
{
  FaceSets fans(around.size());
  std::map<std::int32_t, std::size_t> first_at;
  for (std::size_t i = 0; i < around.size(); ++i)
    for (const std::int32_t corner : faces[around[i]])
      if (corner != vertex)
        fans.unite(i, first_at.emplace(corner, i).first->second);
  std::size_t count = 0;
  for (std::size_t i = 0; i < around.size(); ++i)
    count += fans.find(i) == i;
  return count;
}

} // namespace pcl::acmap::test
