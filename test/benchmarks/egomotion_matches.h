#pragma once

#include "egomotion_input.h"

#include <pcl/core/random.h>
#include <pcl/correspondence.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

namespace pcl::acmap::bench {

/** \brief Two views with matches between their keypoints. */
struct MatchedPair {
  PointCloud<PointXYZRGB>::ConstPtr source, target;
  IndicesPtr target_keypoints;
  Correspondences matches;
  Eigen::Isometry3d truth; ///< T_target_source
};

/** \brief Matches neighbouring views with the public classes.
 * \param[in] target the earlier one of both views */
MatchedPair
matchedPair(const EgomotionSequence& sequence, std::size_t target);

/** \brief Matches of which a fraction leads to random keypoints, and the other ones
 * alone. */
struct SpoiltMatches {
  Correspondences all, right;
};

/** \brief Replaces a fraction of a pair's matches by wrong ones. */
SpoiltMatches
spoilt(const MatchedPair& pair, double share, Random& random);

} // namespace pcl::acmap::bench
