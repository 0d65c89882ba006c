#include "mesh_steps.h"

#include "predicates.h"

#include <array>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

constexpr std::size_t max_sides = 8;

/** \brief The edges of a hole; each begins where the previous one ends. */
using Hole = std::vector<Side>;

/** \brief Finds holes by walking around them from each open edge of their first
 * corner. */
class HoleSearch {
public:
  HoleSearch(GrowingMesh& mesh, const Range& range)
  : mesh_(mesh)
  , range_(range)
  , is_whole_(range.isWhole(mesh.arrays().tree))
  {}

  std::vector<Hole>
  run()
  {
    std::vector<Hole> holes;
    for (const Side& side : mesh_.openSides(range_.begin, range_.end))
      for (const std::int32_t first : {side.a, side.b})
        if (Hole hole; walk(first, side, hole))
          holes.push_back(std::move(hole));
    return holes;
  }

private:
  /** \brief Returns true if a small hole begins with an edge at its first corner. */
  bool
  walk(std::int32_t first, const Side& begin, Hole& hole)
  {
    if (!isLookedAt(first) || !isPassable(first))
      return false;
    hole.push_back(begin);
    std::int32_t corner = begin.a == first ? begin.b : begin.a;
    while (corner != first) {
      if (hole.size() == max_sides || (isLookedAt(corner) && corner < first) ||
          !isPassable(corner))
        return false;
      const std::int32_t next = mesh_.endOfFan(corner, hole.back());
      const Edge& edge = *mesh_.arrays().find(corner, next);
      const bool from_corner = bool(edge.ascending) == (corner < next);
      hole.push_back(from_corner ? Side{corner, next} : Side{next, corner});
      corner = next;
    }
    // Each hole is found in both directions.
    const Side& last = hole.back();
    return hole.size() >= 3 && begin.a + begin.b < last.a + last.b &&
           isOrientable(first, hole);
  }

  /** \brief Can the hole be filled with a consistent orientation of the components
   * around it? */
  bool
  isOrientable(std::int32_t first, const Hole& hole)
  {
    std::array<ParityUnion::Root, max_sides> runs;
    std::int32_t corner = first;
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const Side& side = hole[i];
      const Edge& edge = *mesh_.arrays().find(side.a, side.b);
      runs[i] = mesh_.parity().find(edge.componentNumber());
      runs[i].flipped ^= side.a != corner;
      for (std::size_t j = 0; j < i; ++j)
        if (runs[j].flipped != runs[i].flipped &&
            (runs[j].component == runs[i].component || mesh_.arrays().facing.isKnown()))
          return false;
      corner = side.a == corner ? side.b : side.a;
    }
    return true;
  }

  /** \brief Does the corner have exactly one fan, without points of another task? */
  bool
  isPassable(std::int32_t corner) const
  {
    if (!range_.contains(corner))
      return false;
    MeshArrays& arrays = mesh_.arrays();
    return arrays.vertex(corner).open_edges == 2 &&
           (is_whole_ || !arrays.is(corner, VertexFlag::of_wall));
  }

  bool
  isLookedAt(std::int32_t corner) const
  {
    return range_.contains(corner) &&
           (!is_whole_ || mesh_.arrays().is(corner, VertexFlag::of_wall));
  }

  GrowingMesh& mesh_;
  const Range& range_;
  const bool is_whole_;
};

/** \brief Computes the triangulation of a hole with the smallest maximum turn, by
 * dynamic programming over ranges of its corners. */
class HoleFilling {
public:
  HoleFilling(const SizeConstraint& size, GrowingMesh& mesh, const Hole& hole)
  : tree_(mesh.arrays().tree)
  , size_(size)
  , mesh_(mesh)
  , hole_(hole)
  {
    for (std::size_t i = 0; i < hole.size(); ++i)
      corners_.push_back(
          sharedCorner(hole[i], hole[(i + hole.size() - 1) % hole.size()]));
    best_.assign(corners_.size() * corners_.size(), {});
    for (std::size_t length = 1; length < corners_.size(); ++length)
      for (std::size_t first = 0; first + length < corners_.size(); ++first)
        solve(first, first + length);
  }

  /** \brief Adds the triangles if all their turns are permitted. */
  void
  fill()
  {
    const std::size_t last = corners_.size() - 1;
    const Run& whole = best(0, last);
    if (whole.cosine > cos_largest_turn &&
        cosine(0, last, corners_[whole.apex], mesh_.oppositeOf(hole_[last])) >
            cos_largest_turn)
      add(0, last, hole_[last]);
  }

private:
  /** A range of consecutive corners, closed by the chord between the first and the last
   * one. */
  struct Run {
    double cosine = -2;   ///< largest turn without chord; -2: impossible
    std::size_t apex = 0; ///< corner of the triangle at the chord
  };

  static std::int32_t
  sharedCorner(const Side& side, const Side& previous)
  {
    return side.a == previous.a || side.a == previous.b ? side.a : side.b;
  }

  Run&
  best(std::size_t first, std::size_t last)
  {
    return best_[first * corners_.size() + last];
  }

  double
  cosine(std::size_t first, std::size_t last, std::int32_t p, std::int32_t q) const
  {
    return cosineOfTurn(tree_.position(corners_[first]),
                        tree_.position(corners_[last]),
                        tree_.position(p),
                        tree_.position(q));
  }

  bool
  isChordAllowed(std::size_t first, std::size_t last)
  {
    const std::int32_t a = corners_[first], b = corners_[last];
    return (first == 0 && last + 1 == corners_.size()) ||
           (!mesh_.hasEdge(a, b) &&
            size_.allows(a, b, (tree_.position(a) - tree_.position(b)).squaredNorm()));
  }

  /** \brief Minimum cosine inside a range and at its chord, if corner \a apex is
   * added. */
  double
  cosineAtChord(std::size_t first, std::size_t last, std::size_t apex)
  {
    const std::int32_t inner = last == first + 1 ? mesh_.oppositeOf(hole_[first])
                                                 : corners_[best(first, last).apex];
    return std::min(best(first, last).cosine,
                    cosine(first, last, inner, corners_[apex]));
  }

  void
  solve(std::size_t first, std::size_t last)
  {
    Run& run = best(first, last);
    if (last == first + 1) {
      run.cosine = 1;
      return;
    }
    if (!isChordAllowed(first, last))
      return;
    for (std::size_t apex = first + 1; apex < last; ++apex) {
      if (best(first, apex).cosine < -1 || best(apex, last).cosine < -1 ||
          isDegenerate(tree_.position(corners_[first]),
                       tree_.position(corners_[apex]),
                       tree_.position(corners_[last])))
        continue;
      const double sharpest =
          std::min(cosineAtChord(first, apex, last), cosineAtChord(apex, last, first));
      if (sharpest > run.cosine)
        run = {sharpest, apex};
    }
  }

  /** \brief Adds the triangle over a chord, then those of the two ranges beside it. */
  void
  add(std::size_t first, std::size_t last, const Side& chord)
  {
    if (last == first + 1)
      return;
    const std::size_t apex = best(first, last).apex;
    const std::int32_t p = corners_[apex];
    mesh_.add(mesh_.propose(chord, p));
    // The new triangle is (b, a, p): its new edges are a p and p b.
    const bool starts_at_first = chord.a == corners_[first];
    add(first, apex, starts_at_first ? Side{chord.a, p} : Side{p, chord.b});
    add(apex, last, starts_at_first ? Side{p, chord.b} : Side{chord.a, p});
  }

  const PointTree& tree_;
  const SizeConstraint& size_;
  GrowingMesh& mesh_;
  const Hole& hole_;
  std::vector<std::int32_t> corners_; ///< edge i is from corner i to corner i + 1
  std::vector<Run> best_;
};

} // namespace

void
closeSmallHoles(const SizeConstraint& size, GrowingMesh& mesh, const Range& range)
{
  for (const Hole& hole : HoleSearch(mesh, range).run())
    HoleFilling(size, mesh, hole).fill();
}

} // namespace pcl::acmap::ACMAP_DEWALL
