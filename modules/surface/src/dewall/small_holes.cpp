#include "small_holes.h"

#include "predicates.h"

#include <pcl/core/triangle_mesh.h>

#include <map>

namespace pcl::acmap::dewall {

namespace {

constexpr std::size_t most_sides = 8;

/** \brief The sides of a hole, each beginning where the one before it ends. */
using Hole = std::vector<Side>;

/** \brief Holes of few sides; every corner of a rim has two open sides. */
std::vector<Hole>
findSmallHoles(GrowingMesh& mesh)
{
  std::map<std::int32_t, std::vector<Side>> at;
  for (const Side& side : mesh.openSides()) {
    at[side.a].push_back(side);
    at[side.b].push_back(side);
  }
  const auto follow = [&](const Side& side, std::int32_t corner) {
    const std::vector<Side>& both = at.at(corner);
    return both[0].a == side.a && both[0].b == side.b ? both[1] : both[0];
  };
  std::vector<Hole> holes;
  for (const auto& [first, sides] : at) {
    Hole hole{sides[0]};
    std::int32_t corner = sides[0].a == first ? sides[0].b : sides[0].a;
    std::int32_t lowest = first;
    while (corner != first && hole.size() <= most_sides) {
      lowest = std::min(lowest, corner);
      hole.push_back(follow(hole.back(), corner));
      corner = hole.back().a == corner ? hole.back().b : hole.back().a;
    }
    if (corner == first && lowest == first && hole.size() <= most_sides)
      holes.push_back(std::move(hole));
  }
  return holes;
}

/** \brief The triangulation of a hole whose sharpest turn is the gentlest, by dynamic
 * programming over runs of its corners. */
class HoleFilling {
public:
  HoleFilling(const PointTree& tree,
              const SizeConstraint& size,
              GrowingMesh& mesh,
              const Hole& hole)
  : tree_(tree)
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

  /** \brief Adds the triangles if all of their turns are allowed. */
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
  /** The corners from the first to the last of a run, closed by the chord between them. */
  struct Run {
    double cosine = -2; ///< of the sharpest turn inside, chord excepted; -2: impossible
    std::size_t apex = 0; ///< corner that makes a triangle with the chord
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

  /** \brief Turn at the chord of a run from what lies inside the run to corner \a apex. */
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

  /** \brief Adds the triangle over a chord, then those of the two runs beside it. */
  void
  add(std::size_t first, std::size_t last, const Side& chord)
  {
    if (last == first + 1)
      return;
    const std::size_t apex = best(first, last).apex;
    const std::int32_t p = corners_[apex];
    mesh_.add(chord, p, TriangleMesh::no_wall);
    // The new triangle runs b a p: its new sides are a p and p b.
    const bool starts_at_first = chord.a == corners_[first];
    add(first, apex, starts_at_first ? Side{chord.a, p} : Side{p, chord.b});
    add(apex, last, starts_at_first ? Side{p, chord.b} : Side{chord.a, p});
  }

  const PointTree& tree_;
  const SizeConstraint& size_;
  GrowingMesh& mesh_;
  const Hole& hole_;
  std::vector<std::int32_t> corners_; ///< side i runs from corner i to corner i + 1
  std::vector<Run> best_;
};

} // namespace

void
closeSmallHoles(const PointTree& tree, const SizeConstraint& size, GrowingMesh& mesh)
{
  for (const Hole& hole : findSmallHoles(mesh))
    HoleFilling(tree, size, mesh, hole).fill();
}

} // namespace pcl::acmap::dewall
