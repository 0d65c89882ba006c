#pragma once

#include "stereo_input.h"

#include <pcl/stereo/trinocular_matching.h>

namespace pcl::acmap::bench {

inline constexpr int bag_least = 48;       ///< px, where the search begins
inline constexpr int bag_disparities = 64; ///< px, how far it goes

/** \brief Whether the bag's images are there; says so where they are not. */
bool
hasBag(const char* section);

/** \brief A bag before a wall under ten patterns of random lines, seen by two cameras. The
 * images are computed from 46 real captures under Gray-code patterns, since light adds up,
 * and so have less noise than real shots. The truth, for half of the pixels, is decoded from
 * the same captures: +-0.25 px. */
StereoShots
loadBag();

/** \brief The same under the projector's white: what there is without patterns. */
TrinocularFrame::ConstPtr
loadPassiveBag();

/** \brief The matching, with the range of the bag. */
TrinocularMatching
bagMatching();

} // namespace pcl::acmap::bench
