#pragma once

#include "edge_table.h"
#include "facing.h"
#include "parity_union.h"
#include "point_tree.h"

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
  std::uint8_t depth;     ///< of the wall that made it
};

/** \brief The mesh while it grows, and the guard that keeps it a manifold.
 *
 * Each vertex counts its open edges: 0 is unused or *saturated* (its fan is closed), 2
 * one open fan, more a *pinch*, which later triangles may mend. */
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

  GrowingMesh(const PointTree& tree, const Facing& facing)
  : tree_(tree)
  , facing_(facing)
  , edges_(tree.size())
  , vertices_(static_cast<std::size_t>(tree.size()))
  {}

  /** \brief Would triangle (b, a, apex) over an open side keep the guarantees? */
  Verdict
  judge(const Side& side, std::int32_t apex);

  /** \brief Would triangle (b, a, apex) show its back to the side from which its points
   * were seen? False where that is not known. */
  bool
  isContrary(const Side& side, std::int32_t apex);

  /** \brief Cosine of the largest turn that triangle would make at one of its sides. */
  double
  steepestCosine(const Side& side, std::int32_t apex);

  Bridge
  bridge(const Side& side, std::int32_t apex);

  /** \brief Adds triangle (b, a, apex) over an open side. */
  void
  add(const Side& side, std::int32_t apex, std::uint8_t depth);

  /** \brief Adds the first triangle of a component, turned to its face. */
  void
  addSeed(const std::array<std::int32_t, 3>& corners, std::uint8_t depth);

  bool
  hasEdge(std::int32_t a, std::int32_t b)
  {
    return findUsed(a, b) != nullptr;
  }

  /** \brief Third corner of the only triangle at a side; -1 when it is not open. */
  std::int32_t
  oppositeOf(const Side& side);

  bool
  isUsed(std::int32_t i) const
  {
    return vertex(i).used;
  }

  bool
  isSaturated(std::int32_t i) const
  {
    return vertex(i).used && vertex(i).open_edges == 0;
  }

  const std::vector<GrownTriangle>&
  triangles() const
  {
    return triangles_;
  }

  /** \brief Sides of the triangle added last. */
  std::vector<Side>
  sidesOfLast() const
  {
    const auto [a, b, c] = triangles_.back().corners;
    return {{a, b}, {b, c}, {c, a}};
  }

  /** \brief Open sides, by ascending lower end. */
  std::vector<Side>
  openSides();

  /** \brief Removes all but the largest fan of every pinched vertex, and what that
   * pinches in turn.
   * \return number of triangles removed */
  std::size_t
  keepLargestFans();

  /** \brief Does a triangle run the other way round than the root of its component? */
  bool
  isFlipped(const GrownTriangle& triangle)
  {
    return parity_.find(triangle.component).flipped;
  }

  /** \brief Triangles not made because their component would be a Moebius band. */
  std::size_t
  refusedMoebius() const
  {
    return refused_moebius_;
  }

private:
  struct Vertex {
    Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< sum over its triangles, ...
    std::int32_t component = -1;                      ///< ... as this component runs
    std::uint16_t open_edges = 0;
    bool used = false;
    bool was_pinched = false;
  };

  Vertex&
  vertex(std::int32_t i)
  {
    return vertices_[static_cast<std::size_t>(i)];
  }

  const Vertex&
  vertex(std::int32_t i) const
  {
    return vertices_[static_cast<std::size_t>(i)];
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
  demands(const Side& side, std::int32_t apex, const Edge* at_a, const Edge* at_b);

  /** \brief Is the triangle thin, or far from the mean normal at one of the ends of its
   * side? A chain of gentle turns can turn over as well as a steep one. */
  bool
  isOdd(const Side& side, std::int32_t apex);

  Eigen::Vector3f
  areaVector(const std::array<std::int32_t, 3>& corners) const;

  bool
  isOrientable(const Side& side, std::int32_t apex, const Edge* at_a, const Edge* at_b);

  const Edge*
  findUsed(std::int32_t a, std::int32_t b);

  double
  cosineOfTurnAt(std::int32_t a,
                 std::int32_t b,
                 const Edge& edge,
                 std::int32_t corner) const;

  void
  put(const GrownTriangle& triangle);

  void
  attach(std::int32_t from,
         std::int32_t to,
         std::int32_t opposite,
         std::int32_t component);

  bool
  removeSmallerFans(std::vector<bool>& removed);

  void
  forget(const std::vector<bool>& removed);

  const PointTree& tree_;
  const Facing& facing_;
  EdgeTable edges_;
  std::vector<Vertex> vertices_;
  std::vector<GrownTriangle> triangles_;
  ParityUnion parity_;
  std::size_t refused_moebius_ = 0;
};

} // namespace pcl::acmap::dewall
