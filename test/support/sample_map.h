#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/random.h>

namespace pcl::acmap::test {

/** \brief A map of two planes with odd numbers: the first has two polygons, one with a
 * hole, and a chart on each; the second has none. Two poses. */
CompactMap
makeSampleMap();

/** \brief Expects the same numbers, to the bit. */
void
expectSamePlanes(const CompactMap& map, const CompactMap& wanted);

/** \param[in] with_images whether colours and kinds too are the same */
void
expectSameCharts(const CompactMap& map, const CompactMap& wanted, bool with_images);

} // namespace pcl::acmap::test
