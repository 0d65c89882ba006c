#pragma once

#include "egomotion_input.h"

#include <pcl/core/random.h>
#include <pcl/correspondence.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

namespace pcl::acmap::bench {

/** \brief Two views with the matches between their keypoints. */
struct MatchedPair {
  PointCloud<PointXYZRGB>::ConstPtr source, target;
  IndicesPtr target_keypoints;
  Correspondences matches;
  Eigen::Isometry3d truth; ///< T_target_source
};

/** \brief Matches neighbours by the public classes.
 * \param[in] target the earlier view of both */
MatchedPair
matchedPair(const EgomotionSequence& sequence, std::size_t target);

/** \brief Matches, a share of them led to keypoints drawn at random, and the others alone. */
struct SpoiltMatches {
  Correspondences all, right;
};

/** \brief Spoils a share of a pair's matches. */
SpoiltMatches
spoilt(const MatchedPair& pair, double share, Random& random);

} // namespace pcl::acmap::bench
