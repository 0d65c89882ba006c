#pragma once

#include "edge_pool.h"
#include "facing.h"
#include "point_tree.h"

#include <atomic>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief A vertex of the mesh. The number of its open edges is 0 if it is unused or
 * *saturated* (its fan is closed), 2 for one open fan, and more for a *pinch*, which
 * later triangles may resolve. */
struct Vertex {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< sum over its triangles, ...
  std::int32_t component = -1;  ///< ... in this component's orientation
  std::int32_t first_edge = -1; ///< head of the list of edges with it as lower end
  std::int32_t open_ends = 0;   ///< XOR of the other ends of its open edges
  std::uint16_t triangles = 0;
  std::uint16_t open_edges = 0;
};

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
  std::vector<Vertex> vertices;
  std::vector<std::uint8_t> flags; ///< VertexFlag of each vertex
  EdgePool edges;
  std::vector<std::uint16_t> saturated, unused; ///< bits for the points of each leaf
  /** Number of unused points in each group of eight leaves, which small tasks may
   * share. */
  std::vector<std::atomic<std::uint8_t>> unused_in_group;

  MeshArrays(const PointTree& t, const Facing& f)
  : tree(t)
  , facing(f)
  , vertices(static_cast<std::size_t>(t.size()))
  , flags(static_cast<std::size_t>(t.size()))
  , edges(t.size())
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

  Vertex&
  vertex(std::int32_t i)
  {
    return vertices[static_cast<std::size_t>(i)];
  }

  bool
  is(std::int32_t i, std::uint8_t flag) const
  {
    return (flags[static_cast<std::size_t>(i)] & flag) != 0;
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

  /** \brief Returns the edge between two points, nullptr if there is none. */
  Edge*
  find(std::int32_t a, std::int32_t b)
  {
    const std::int32_t high = std::max(a, b);
    for (std::int32_t e = vertex(std::min(a, b)).first_edge; e >= 0;) {
      Edge& edge = edges[e];
      if (edge.high == high)
        return &edge;
      e = edge.next;
    }
    return nullptr;
  }

  /** \brief Removes the edge between two points from its list.
   * \return its index in the pool */
  std::int32_t
  unlink(std::int32_t a, std::int32_t b)
  {
    const std::int32_t high = std::max(a, b);
    std::int32_t* link = &vertex(std::min(a, b)).first_edge;
    while (edges[*link].high != high)
      link = &edges[*link].next;
    const std::int32_t place = *link;
    *link = edges[place].next;
    return place;
  }

  /** \brief Calls function (edge) for the edges whose lower end is \a low. */
  template <typename Function>
  void
  forEachEdgeAt(std::int32_t low, const Function& function)
  {
    for (std::int32_t e = vertex(low).first_edge; e >= 0;) {
      Edge& edge = edges[e];
      e = edge.next;
      function(edge);
    }
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
  void
  setBit(std::vector<std::uint16_t>& masks, std::int32_t i, bool value) const
  {
    const std::int32_t leaf = tree.leafOf(i);
    const unsigned bit = 1u << (i - tree.firstOfLeaf(leaf));
    std::uint16_t& bits = masks[static_cast<std::size_t>(leaf)];
    bits = static_cast<std::uint16_t>(value ? bits | bit : bits & ~bit);
  }
};

} // namespace pcl::acmap::ACMAP_DEWALL
