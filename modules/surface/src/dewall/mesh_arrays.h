#pragma once

#include "edge_pool.h"
#include "facing.h"
#include "point_tree.h"
#include "triangle_store.h"

#include <algorithm>
#include <atomic>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A vertex of the mesh. The number of its open edges is 0 if it is unused or
 * *saturated* (its fan is closed), 2 for one open fan, and more for a *pinch*, which
 * later triangles may resolve.
 *
 * What the guard asks for most often, the edges with it as lower end, is in the same
 * line of the cache. */
struct alignas(64) Vertex {
  EdgeBlock first_edges;
  std::int32_t more_edges = -1; ///< in the pool, -1: there are no others
  std::int32_t component = -1;  ///< of its first triangle
  std::int32_t open_ends = 0;   ///< XOR of the other ends of its open edges
  std::uint16_t triangles = 0;
  std::uint16_t open_edges = 0;
};

static_assert(sizeof(Vertex) == 64);

/** \brief Properties of vertices that passes over all triangles ask for. */
struct VertexFlag {
  static constexpr std::uint8_t pinched = 1; ///< it had several fans
  static constexpr std::uint8_t lost = 2;    ///< a triangle was removed
  static constexpr std::uint8_t mixed = 4;   ///< triangles of several components meet
  static constexpr std::uint8_t of_wall = 8; ///< used by a triangle across a plane
};

/** \brief The arrays of the mesh, shared by the tasks that grow it: each task has its
 * own range of points and does not access data of the others. */
struct MeshArrays {
  const PointTree& tree;
  const Facing& facing;
  LargeVector<Vertex> vertices;
  /** Sums of the normals of the triangles at each vertex, in the orientation of its
   * component. */
  LargeVector<Eigen::Vector3f> normals;
  LargeVector<std::uint8_t> flags; ///< VertexFlag of each vertex
  EdgePool edges;
  TriangleStore triangles;                      ///< those of finished parts
  LargeVector<std::uint16_t> saturated, unused; ///< bits for the points of each leaf
  /** Number of unused points in each group of eight leaves, which small tasks may
   * share. */
  LargeVector<std::atomic<std::uint8_t>> unused_in_group;

  MeshArrays(const PointTree& t, const Facing& f)
  : tree(t)
  , facing(f)
  , vertices(static_cast<std::size_t>(t.size()))
  , normals(static_cast<std::size_t>(t.size()), Eigen::Vector3f::Zero())
  , flags(static_cast<std::size_t>(t.size()))
  , edges(t.size())
  , triangles(t.size())
  , saturated(static_cast<std::size_t>(t.leafCount()))
  , unused(static_cast<std::size_t>(t.leafCount()))
  , unused_in_group(static_cast<std::size_t>((t.leafCount() + 7) / 8))
  {
    for (std::int32_t leaf = 0; leaf < t.leafCount(); ++leaf) {
      const std::int32_t points = t.firstOfLeaf(leaf + 1) - t.firstOfLeaf(leaf);
      unused[static_cast<std::size_t>(leaf)] =
          static_cast<std::uint16_t>((1u << points) - 1);
      unused_in_group[static_cast<std::size_t>(leaf / 8)] +=
          static_cast<std::uint8_t>(points);
    }
  }

  MeshArrays(const MeshArrays&) = delete;
  MeshArrays&
  operator=(const MeshArrays&) = delete;

  /** \brief Frees the memory of vertices and edges. */
  void
  releaseVertices()
  {
    LargeVector<Vertex>().swap(vertices);
    LargeVector<Eigen::Vector3f>().swap(normals);
    edges.clear();
  }

  Vertex&
  vertex(std::int32_t i)
  {
    return vertices[static_cast<std::size_t>(i)];
  }

  std::uint8_t
  flagsOf(std::int32_t i) const
  {
    return flags[static_cast<std::size_t>(i)];
  }

  bool
  is(std::int32_t i, std::uint8_t flag) const
  {
    return (flagsOf(i) & flag) != 0;
  }

  void
  set(std::int32_t i, std::uint8_t flag)
  {
    flags[static_cast<std::size_t>(i)] |= flag;
  }

  void
  clear(std::int32_t i, std::uint8_t flag)
  {
    flags[static_cast<std::size_t>(i)] &= static_cast<std::uint8_t>(~flag);
  }

  /** \brief Notes at both ends that an edge was opened (1) or closed (-1). */
  void
  countOpenEdge(std::int32_t a, std::int32_t b, int change)
  {
    for (const auto& [at, other] : {std::pair(a, b), std::pair(b, a)}) {
      Vertex& v = vertex(at);
      v.open_edges = static_cast<std::uint16_t>(v.open_edges + change);
      v.open_ends ^= other;
    }
  }

  bool
  isUsed(std::int32_t i) const
  {
    return vertices[static_cast<std::size_t>(i)].triangles > 0;
  }

  Eigen::Vector3f&
  normal(std::int32_t i)
  {
    return normals[static_cast<std::size_t>(i)];
  }

  /** \brief Returns the edge between two points, nullptr if there is none. */
  Edge*
  find(std::int32_t a, std::int32_t b)
  {
    const std::int32_t high = std::max(a, b);
    Vertex& low = vertex(std::min(a, b));
    Edge* edge = low.first_edges.find(high);
    for (std::int32_t more = low.more_edges; !edge && more >= 0;) {
      MoreEdges& entry = edges[more];
      edge = entry.block.find(high);
      more = entry.next;
    }
    return edge;
  }

  /** \brief Adds an edge between two points that have none. */
  Edge&
  addEdge(std::int32_t a, std::int32_t b, EdgePool::Cursor& memory);

  /** \brief Removes the edge between two points; the order of the others does not
   * change. */
  void
  removeEdge(std::int32_t a, std::int32_t b, EdgePool::Cursor& memory);

  /** \brief Calls function (edge, its higher end) for the edges whose lower end is \a
   * low, the last one first. */
  template <typename Function>
  void
  forEachEdgeAt(std::int32_t low, const Function& function)
  {
    Vertex& v = vertex(low);
    forEachEdgeIn(v.first_edges, v.more_edges, function);
  }

  void
  noteSaturation(std::int32_t i, bool is_saturated)
  {
    setBit(saturated, i, is_saturated);
  }

  void
  noteUse(std::int32_t i, bool is_used)
  {
    setBit(unused, i, !is_used);
    const auto change = static_cast<std::uint8_t>(is_used ? -1 : 1);
    unused_in_group[static_cast<std::size_t>(tree.leafOf(i) / 8)].fetch_add(
        change, std::memory_order_relaxed);
  }

private:
  template <typename Function>
  void
  forEachEdgeIn(EdgeBlock& block, std::int32_t more, const Function& function)
  {
    if (more >= 0)
      forEachEdgeIn(edges[more].block, edges[more].next, function);
    for (int place = EdgeBlock::capacity; place-- > 0;)
      if (block.high[place] != EdgeBlock::empty)
        function(block.edges[place], block.high[place]);
  }

  void
  setBit(LargeVector<std::uint16_t>& masks, std::int32_t i, bool value) const
  {
    const std::int32_t leaf = tree.leafOf(i);
    const unsigned bit = 1u << (i - tree.firstOfLeaf(leaf));
    std::uint16_t& bits = masks[static_cast<std::size_t>(leaf)];
    bits = static_cast<std::uint16_t>(value ? bits | bit : bits & ~bit);
  }
};

} // namespace pcl::acmap::ACMAP_DEWALL
