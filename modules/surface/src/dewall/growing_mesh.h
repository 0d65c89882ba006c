#pragma once

#include "mesh_arrays.h"
#include "parity_union.h"
#include "triangle_store.h"

#include <array>
#include <tuple>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief An edge with one triangle, which traverses it from a to b. */
struct Side {
  std::int32_t a, b;
};

/** \brief The edges of a triangle in its orientation. */
inline std::array<Side, 3>
sidesOf(const GrownTriangle& triangle)
{
  const auto [a, b, c] = triangle.corners;
  return {Side{a, b}, Side{b, c}, Side{c, a}};
}

/** \brief Triangle (b, a, apex) over an open edge, with the edges of the mesh that would
 * be its own; valid until the mesh changes. */
struct Proposal {
  Side side;
  std::int32_t apex;
  Edge* base;
  Edge *at_a, *at_b; ///< from these ends to the apex; nullptr: the edge would be new
};

/** \brief Triangles of one wall, or of one leaf. */
struct TriangleList {
  GrownTriangles* triangles;
  std::uint8_t depth; ///< depth of the divide step, 255 for the last passes
};

/** \brief Two components that share an edge; flipped: one of them has to be flipped. */
struct Joint {
  std::int32_t first, second;
  bool flipped;
};

/** \brief The part of the mesh that one task grows, with the guard that keeps it
 * manifold. */
class GrowingMesh {
public:
  /** Doubtful: permitted, but with a steep turn or thin, so that it may cause half a
   * wall to be flipped. Pinches: it starts a second fan at its apex. */
  enum class Verdict { Fits, Doubtful, Pinches, Blocked };

  /** \brief The two components that a triangle would connect, and whether one of them
   * has to be flipped for that; first < 0: none. */
  struct Bridge {
    std::int32_t first = -1, second = -1;
    bool flipped = false;

    bool
    operator<(const Bridge& other) const
    {
      return std::tie(first, second, flipped) <
             std::tie(other.first, other.second, other.flipped);
    }
  };

  /** \param[in] parity orientations of the components of the walls above */
  GrowingMesh(MeshArrays& arrays, ParityUnion parity)
  : arrays_(arrays)
  , tree_(arrays.tree)
  , facing_(arrays.facing)
  , memory_of_edges_(arrays.edges)
  , parity_(std::move(parity))
  {}

  MeshArrays&
  arrays()
  {
    return arrays_;
  }

  /** \brief Sets whether the following triangles cross a splitting plane. */
  void
  setOfWall(bool is_of_wall)
  {
    is_of_wall_ = is_of_wall;
  }

  Proposal
  propose(const Side& side, std::int32_t apex)
  {
    return propose(side, apex, arrays_.find(side.a, side.b));
  }

  /** \param[in] base edge of the side */
  Proposal
  propose(const Side& side, std::int32_t apex, Edge* base)
  {
    return {side, apex, base, arrays_.find(side.a, apex), arrays_.find(side.b, apex)};
  }

  /** \brief Checks whether a triangle keeps the mesh manifold. */
  Verdict
  judge(const Proposal& proposal);

  /** \brief Would the back of triangle (b, a, apex) face the side from which its points
   * were measured? False if that is unknown. */
  bool
  isContrary(const Side& side, std::int32_t apex) const
  {
    return facing_.shownArea(tree_, {side.b, side.a, apex}) < 0;
  }

  Bridge
  bridge(const Proposal& proposal);

  void
  add(const Proposal& proposal);

  /** \brief Adds the first triangle of a component, oriented by its facing
   * direction. */
  void
  addSeed(const std::array<std::int32_t, 3>& corners);

  /** \brief Removes a triangle but leaves it in its list, with a mark; call sweep ()
   * after all removals. */
  void
  takeOut(GrownTriangle& triangle);

  /** \brief Erases the removed triangles from their lists, and assigns the open edges
   * between components to the remaining triangles. */
  void
  sweep(const std::vector<GrownTriangles*>& lists);

  bool
  hasEdge(std::int32_t a, std::int32_t b)
  {
    return arrays_.find(a, b) != nullptr;
  }

  /** \brief Begins to load the vertices of an edge that will be processed soon. */
  void
  prefetch(const Side& side) const
  {
    __builtin_prefetch(&arrays_.vertex(side.a));
    __builtin_prefetch(&arrays_.vertex(side.b));
  }

  /** \brief Returns an edge if it is open, otherwise nullptr. */
  Edge*
  findOpen(const Side& side)
  {
    Edge* edge = arrays_.find(side.a, side.b);
    return edge && edge->isOpen() ? edge : nullptr;
  }

  /** \brief Third corner of the only triangle at an edge; -1 if the edge is not
   * open. */
  std::int32_t
  oppositeOf(const Side& side)
  {
    const Edge* edge = findOpen(side);
    return edge ? edge->opposites : -1;
  }

  /** \brief An open edge in the direction in which its triangle traverses it. */
  Side
  asItRuns(const Side& side)
  {
    const Edge* edge = arrays_.find(side.a, side.b);
    return bool(edge->ascending) == (side.a < side.b) ? side : Side{side.b, side.a};
  }

  /** \brief Follows a fan at vertex \a at from one open edge over its triangles to the
   * other open edge, and returns the other end of that edge. */
  std::int32_t
  endOfFan(std::int32_t at, const Side& side);

  bool
  isUsed(std::int32_t i) const
  {
    return arrays_.isUsed(i);
  }

  bool
  isSaturated(std::int32_t i) const
  {
    const Vertex& v = arrays_.vertices[static_cast<std::size_t>(i)];
    return v.triangles > 0 && v.open_edges == 0;
  }

  const GrownTriangles&
  triangles() const
  {
    return triangles_;
  }

  GrownTriangles&
  triangles()
  {
    return triangles_;
  }

  /** \brief Edges of the last added triangle. */
  std::array<Side, 3>
  sidesOfLast() const
  {
    return sidesOf(triangles_.back());
  }

  /** \brief Open edges with the lower end in [begin, end), in ascending order of this
   * end. */
  std::vector<Side>
  openSides(std::int32_t begin, std::int32_t end);

  ParityUnion&
  parity()
  {
    return parity_;
  }

  std::vector<Joint>
  takeJoints()
  {
    return std::exchange(joints_, {});
  }

  /** \brief Number of triangles that were rejected because their component would become
   * a Moebius strip. */
  std::size_t
  refusedMoebius() const
  {
    return refused_moebius_;
  }

private:
  Vertex&
  vertex(std::int32_t i)
  {
    return arrays_.vertex(i);
  }

  /** Required orientations of a new triangle by its neighbours. */
  struct Demands {
    struct Demand {
      std::int32_t root;
      bool flipped;
    };
    std::array<Demand, 3> of;
    std::size_t count = 0;
  };

  Demands
  demands(const Proposal& proposal);

  /** \brief Is the triangle thin, or is its normal far from the mean normal at one of
   * the ends of its edge? A chain of gentle turns can flip the orientation just as a
   * steep one. */
  bool
  isOdd(const Side& side, std::int32_t apex, std::int32_t component);

  Eigen::Vector3f
  areaVector(const std::array<std::int32_t, 3>& corners) const;

  bool
  isOrientable(const Demands& demands) const;

  /** \brief Cosine of the largest turn of the triangle at one of its edges. */
  double
  steepestCosine(const Proposal& proposal) const;

  /** \param[in] edges those of \ref sidesOf; nullptr: the edge is new */
  void
  put(const GrownTriangle& triangle, const std::array<Edge*, 3>& edges);

  void
  attach(const Side& side, Edge* edge, std::int32_t opposite, std::int32_t component);

  void
  addToVertex(std::int32_t corner, std::int32_t component, const Eigen::Vector3f& area);

  /** \brief Takes a triangle from an edge. Which triangle remains there follows from
   * the removed one, except on a seam. */
  void
  detachEdge(const Side& side, std::int32_t opposite, std::int32_t component);

  void
  reassignSeams(const GrownTriangles& triangles);

  MeshArrays& arrays_;
  const PointTree& tree_;
  const Facing& facing_;
  EdgePool::Cursor memory_of_edges_;
  GrownTriangles triangles_;
  ParityUnion parity_;
  std::vector<Joint> joints_;
  std::size_t refused_moebius_ = 0;
  bool is_of_wall_ = false;
};

} // namespace pcl::acmap::ACMAP_DEWALL
