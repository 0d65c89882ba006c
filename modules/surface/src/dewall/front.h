#pragma once

#include "apex_search.h"
#include "range.h"
#include "third_point.h"

#include <pcl/surface/dewall_types.h>

#include <functional>
#include <utility>

namespace pcl::acmap::dewall {

/** \brief Grows triangles side by side, first in first out ([P] Fig. 6, the while
 * loop).
 */
class Front {
public:
  Front(const PointTree& tree,
        const SizeConstraint& size,
        DeWallRule rule,
        GrowingMesh& mesh,
        std::function<void()> tick)
  : tree_(tree)
  , size_(size)
  , rule_(rule)
  , mesh_(mesh)
  , tick_(std::move(tick))
  {}

  /** \brief Takes a side into its list: L_alpha when alpha cuts it, else for a half. */
  void
  insert(const Side& side, const Range& range)
  {
    (range.isCut(side) ? queue_ : uncut_).push_back(side);
  }

  /** \brief Works L_alpha off; apexes come from the range alone. Triangles that would
   * pinch a vertex or turn steeply are postponed. */
  void
  advance(const Range& range);

  /** \brief Works off what was postponed, now allowing it. */
  void
  advancePostponed(const Range& range);

  /** \brief Works off what would show the sensor its back, last of all: a few such
   * triangles between parts that already fit can turn nothing inside out. */
  void
  advanceContrary(const Range& range);

  /** \brief Tries the triangle of p1, p2 and the p3 of smallest circumcircle as the
   * first of a component (FindFirstTriangle), and works its sides off. */
  void
  startAt(std::int32_t p1, std::int32_t p2, const Range& range);

  /** \brief Hands over the sides not cut by alpha (L_l and L_r). */
  std::vector<Side>
  takeUncut()
  {
    return std::exchange(uncut_, {});
  }

  /** \brief Leaves what waits to the last pass. */
  void
  deferWaiting()
  {
    for (const Candidate& candidate : std::exchange(postponed_, {}))
      deferred_.push_back(candidate.side);
    for (const Side& side : std::exchange(contrary_, {}))
      deferred_.push_back(side);
  }

  /** \brief Hands over the sides left to the last pass: those, and the ones whose apex
   * lay beyond their range. */
  std::vector<Side>
  takeDeferred()
  {
    return std::exchange(deferred_, {});
  }

private:
  enum class Doubt { Postpones, IsAllowed, MayBridge, MayBeContrary };

  /** A triangle that has passed all tests but waits for the doubts about it. */
  struct Candidate {
    Side side;
    std::int32_t apex;
    GrowingMesh::Bridge bridge;
    std::size_t votes = 0; ///< of the bridge
  };

  /** \brief Pending bridges, those of the most popular joints first: when two
   * components touch along a seam, the many decide how they fit, not the first. */
  std::vector<Candidate>
  bridgesByVotes();

  void
  reconsider(const Candidate& candidate, const Range& range, Doubt doubt);

  void
  process(const Side& side, const Range& range, Doubt doubt);

  /** \brief Adds, postpones or gives up; false when another apex may be tried. */
  bool
  tryApex(const Side& side, std::int32_t apex, const Range& range, Doubt doubt);

  /** \brief As above for an apex whose sphere is known to be empty. */
  bool
  tryCandidate(const Side& side, std::int32_t apex, const Range& range, Doubt doubt);

  void
  insertOpen(const Side& side, const Range& range);

  const PointTree& tree_;
  const SizeConstraint& size_;
  const DeWallRule rule_;
  GrowingMesh& mesh_;
  std::function<void()> tick_;
  std::vector<Side> queue_, uncut_, deferred_, contrary_;
  std::vector<Candidate> postponed_, bridges_;
};

} // namespace pcl::acmap::dewall
