#pragma once

#include "stereo_input.h"

#include <pcl/stereo/trinocular_matching.h>

namespace pcl::acmap::bench {

inline constexpr int bag_least = 48;       ///< px, where the search begins
inline constexpr int bag_disparities = 64; ///< px, how far it goes

/** \brief Whether the bag's images are there; says so where they are not. */
bool
hasBag(const char* section);

/** \brief A bag before a wall under ten patterns of random lines, seen by two cameras; the
 * truth was measured by structured light, for half of the pixels. */
StereoShots
loadBag();

/** \brief The same under the projector's white: what there is without patterns. */
TrinocularFrame::ConstPtr
loadPassiveBag();

/** \brief The matching, with the range of the bag. */
TrinocularMatching
bagMatching();

} // namespace pcl::acmap::bench
