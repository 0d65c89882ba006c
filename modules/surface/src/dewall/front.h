#pragma once

#include "apex_search.h"
#include "range.h"
#include "third_point.h"

#include <pcl/surface/dewall_types.h>

#include <functional>
#include <utility>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Grows triangles over edges in the order in which these were found ([P] Fig.
 * 6, the while loop). */
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

  /** \brief Adds an edge to its list: L_alpha if alpha cuts it, otherwise the list of a
   * half. */
  void
  insert(const Side& side, const Range& range)
  {
    (range.isCut(side) ? queue_ : uncut_).push_back(side);
  }

  /** \brief Processes L_alpha, with apexes from the range only. Triangles that would
   * pinch a vertex or make a steep turn are postponed. */
  void
  advance(const Range& range);

  /** \brief Processes the postponed triangles, which are now permitted. */
  void
  advancePostponed(const Range& range);

  /** \brief Finally processes the triangles whose back side would face the sensor: a
   * few of them between parts that already fit cannot flip anything. */
  void
  advanceContrary(const Range& range);

  /** \brief Tries the triangle of p1, p2 and the p3 with the smallest circumcircle as
   * the first one of a component (FindFirstTriangle), and processes its edges. */
  void
  startAt(std::int32_t p1, std::int32_t p2, const Range& range);

  /** \brief Returns the edges that are not cut by alpha (L_l and L_r) and clears their
   * list. */
  std::vector<Side>
  takeUncut()
  {
    return std::exchange(uncut_, {});
  }

  /** \brief Defers the waiting edges to the last pass. */
  void
  deferWaiting()
  {
    for (const Candidate& candidate : std::exchange(postponed_, {}))
      deferred_.push_back(candidate.side);
    for (const Side& side : std::exchange(contrary_, {}))
      deferred_.push_back(side);
  }

  /** \brief Returns the edges that are deferred to the last pass: the waiting ones, and
   * those whose apex is outside of their range. */
  std::vector<Side>
  takeDeferred()
  {
    return std::exchange(deferred_, {});
  }

private:
  enum class Doubt { Postpones, IsAllowed, MayBridge, MayBeContrary };

  /** A triangle that has passed all tests but is postponed because it is doubtful. */
  struct Candidate {
    Side side;
    std::int32_t apex;
    GrowingMesh::Bridge bridge;
    std::size_t votes = 0; ///< votes for the bridge
  };

  /** \brief Returns the pending bridges in order of decreasing votes: if two components
   * touch along a seam, the majority decides how they fit, not the first one. */
  std::vector<Candidate>
  bridgesByVotes();

  void
  reconsider(const Candidate& candidate, const Range& range, Doubt doubt);

  void
  process(const Side& side, const Range& range, Doubt doubt);

  /** \brief Adds, postpones or rejects a triangle. Returns
   * false if another apex may be tried. */
  bool
  tryCandidate(const Proposal& proposal, const Range& range, Doubt doubt);

  const PointTree& tree_;
  const SizeConstraint& size_;
  const DeWallRule rule_;
  GrowingMesh& mesh_;
  std::function<void()> tick_;
  std::vector<Side> queue_, uncut_, deferred_, contrary_;
  std::vector<Candidate> postponed_, bridges_;
};

} // namespace pcl::acmap::ACMAP_DEWALL
