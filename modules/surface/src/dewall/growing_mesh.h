#pragma once

#include "mesh_arrays.h"
#include "parity_union.h"

#include <array>
#include <tuple>
#include <vector>

namespace pcl::acmap::dewall {

/** \brief An edge with one triangle, which runs through it from a to b. */
struct Side {
  std::int32_t a, b;
};

/** \brief A triangle of tree points. */
struct GrownTriangle {
  std::array<std::int32_t, 3> corners;
  std::int32_t component; ///< the seed it grew from; its corners run as that seed's do

  /** \brief True until it is swept out of its list. */
  bool
  isTakenOut() const
  {
    return component < 0;
  }
};

/** \brief The sides of a triangle, as it runs. */
inline std::array<Side, 3>
sidesOf(const GrownTriangle& triangle)
{
  const auto [a, b, c] = triangle.corners;
  return {Side{a, b}, Side{b, c}, Side{c, a}};
}

/** \brief Triangles of one wall, or of one leaf. */
struct TriangleList {
  std::vector<GrownTriangle>* triangles;
  std::uint8_t depth; ///< of the divide step, 255 for the last passes
};

/** \brief Two components that share an edge, one turned over if flipped. */
struct Joint {
  std::int32_t first, second;
  bool flipped;
};

/** \brief The mesh as one task grows it, and the guard that keeps it a manifold. */
class GrowingMesh {
public:
  /** Doubtful: legal, but steep or thin, so that one of them may turn half a wall
   * inside out. Pinches: opens a second fan at its apex. */
  enum class Verdict { Fits, Doubtful, Pinches, Blocked };

  /** \brief Which two components a triangle would join, and whether one of them has to
   * be turned over for that; first < 0: none. */
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

  /** \param[in] parity of the components of the walls above */
  GrowingMesh(MeshArrays& arrays, ParityUnion parity)
  : arrays_(arrays)
  , tree_(arrays.tree)
  , facing_(arrays.facing)
  , new_edges_(arrays.edges)
  , parity_(std::move(parity))
  {}

  MeshArrays&
  arrays()
  {
    return arrays_;
  }

  /** \brief From now on the triangles cross a splitting plane, or do not. */
  void
  setOfWall(bool is_of_wall)
  {
    is_of_wall_ = is_of_wall;
  }

  /** \brief Would triangle (b, a, apex) over an open side keep the guarantees? */
  Verdict
  judge(const Side& side, std::int32_t apex);

  /** \brief Would triangle (b, a, apex) show its back to the side from which its points
   * were seen? False where that is not known. */
  bool
  isContrary(const Side& side, std::int32_t apex) const
  {
    return facing_.shownArea(tree_, {side.b, side.a, apex}) < 0;
  }

  Bridge
  bridge(const Side& side, std::int32_t apex);

  /** \brief Adds triangle (b, a, apex) over an open side. */
  void
  add(const Side& side, std::int32_t apex);

  /** \brief Adds the first triangle of a component, turned to its face. */
  void
  addSeed(const std::array<std::int32_t, 3>& corners);

  /** \brief Takes a triangle out, but leaves it in its list, marked; sweep () is due when
   * all have been taken out. */
  void
  takeOut(GrownTriangle& triangle);

  /** \brief Drops what was taken out from the lists of triangles, and gives the open edges
   * round it to the triangles that stayed. */
  void
  sweep(const std::vector<std::vector<GrownTriangle>*>& lists);

  bool
  hasEdge(std::int32_t a, std::int32_t b)
  {
    return arrays_.find(a, b) != nullptr;
  }

  /** \brief Third corner of the only triangle at a side; -1 when it is not open. */
  std::int32_t
  oppositeOf(const Side& side)
  {
    const Edge* edge = arrays_.find(side.a, side.b);
    return edge && edge->isOpen() ? edge->opposites : -1;
  }

  /** \brief An open side the way its triangle's component runs through it. */
  Side
  asItRuns(const Side& side)
  {
    const Edge* edge = arrays_.find(side.a, side.b);
    return bool(edge->ascending) == (side.a < side.b) ? side : Side{side.b, side.a};
  }

  /** \brief From one open side of a fan at vertex \a at over its triangles to the other:
   * the other end of that side. */
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

  const std::vector<GrownTriangle>&
  triangles() const
  {
    return triangles_;
  }

  std::vector<GrownTriangle>&
  triangles()
  {
    return triangles_;
  }

  /** \brief Sides of the triangle added last. */
  std::array<Side, 3>
  sidesOfLast() const
  {
    return sidesOf(triangles_.back());
  }

  /** \brief Open sides whose lower end is in [begin, end), by ascending lower end. */
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

  /** \brief Triangles not made because their component would be a Moebius band. */
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

  /** What the neighbours of a new triangle ask of its orientation. */
  struct Demands {
    struct Demand {
      std::int32_t root;
      bool flipped;
    };
    std::array<Demand, 3> of;
    std::size_t count = 0;
  };

  Demands
  demands(const Side& side,
          std::int32_t apex,
          const Edge* base,
          const Edge* at_a,
          const Edge* at_b);

  /** \brief Is the triangle thin, or far from the mean normal at one of the ends of its
   * side? A chain of gentle turns can turn over as well as a steep one. */
  bool
  isOdd(const Side& side, std::int32_t apex, std::int32_t component);

  Eigen::Vector3f
  areaVector(const std::array<std::int32_t, 3>& corners) const;

  bool
  isOrientable(const Demands& demands) const;

  /** \brief Cosine of the largest turn the triangle would make at one of its sides. */
  double
  steepestCosine(const Side& side,
                 std::int32_t apex,
                 const Edge* base,
                 const Edge* at_a,
                 const Edge* at_b) const;

  void
  put(const GrownTriangle& triangle);

  void
  attach(std::int32_t from,
         std::int32_t to,
         std::int32_t opposite,
         std::int32_t component);

  void
  reassignEdges(const std::vector<GrownTriangle>& triangles);

  void
  detachEdge(std::int32_t from, std::int32_t to, std::int32_t opposite);

  MeshArrays& arrays_;
  const PointTree& tree_;
  const Facing& facing_;
  EdgePool::Cursor new_edges_;
  std::vector<GrownTriangle> triangles_;
  ParityUnion parity_;
  std::vector<Joint> joints_;
  std::size_t refused_moebius_ = 0;
  bool is_of_wall_ = false;
};

} // namespace pcl::acmap::dewall
