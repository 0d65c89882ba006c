#pragma once

#include "clouds.h"

namespace pcl::acmap::test {

/** \brief Another cloud each round, of 2000 points at most: sheets, rooms and no surface at
 * all; every third round an ugly one, from no point to coordinates of 1e9 m. */
Cloud
makeSoakCloud(unsigned round);

} // namespace pcl::acmap::test
