#pragma once

#include "stereo_input.h"

#include <pcl/stereo/trinocular_matching.h>

namespace pcl::acmap::bench {

inline constexpr int bag_minimum = 48;     ///< px, start of the search range
inline constexpr int bag_disparities = 64; ///< px, size of the search range

/** \brief Do the images of the bag exist? Prints a message if not. */
bool
hasBag(const char* section);

/** \brief A bag in front of a wall under ten patterns of random lines, seen by two
 * cameras. The images are computed from 46 real captures under Gray-code patterns,
 * since light is additive, and therefore have less noise than real shots. The truth,
 * for half of the pixels, is decoded from the same captures: +-0.25 px. */
StereoShots
loadBag();

/** \brief As above under white light of the projector: without patterns. */
TrinocularFrame::ConstPtr
loadPassiveBag();

/** \brief The matching, with the search range for the bag. */
TrinocularMatching
bagMatching();

} // namespace pcl::acmap::bench
