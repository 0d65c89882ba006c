#pragma once

#include "clouds.h"

namespace pcl::acmap::test {

/** \brief A different cloud in each round, with at most 2000 points: sheets, rooms and
 * unstructured points; every third one is degenerate, from an empty one to coordinates
 * of 1e9 m. */
Cloud
makeSoakCloud(unsigned round);

} // namespace pcl::acmap::test
