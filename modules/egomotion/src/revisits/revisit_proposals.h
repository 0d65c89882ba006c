#pragma once

#include "revisits/view_keypoints.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Two views that look alike. */
struct ProposedRevisit {
  std::size_t earlier, later; ///< numbers of the views
};

/** \brief Pairs of views, at least \a min_separation apart, that have many keypoints in
 * common.
 *
 * Each keypoint votes for the other views that its nearest neighbours among all
 * keypoints belong to; the more views it looks like, the less a vote counts. Each view
 * proposes those with most votes. O(n log n) for n keypoints.
 * \return in the order of the later view, then of the earlier one */
std::vector<ProposedRevisit>
proposeRevisits(const std::vector<ViewKeypoints>& views, std::size_t min_separation);

} // namespace pcl::acmap
