#pragma once

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Faults and size of the meshes of both rules and of greedy projection on real
 * clouds. */
void
printSoundness();

/** \brief Uncovered and overlapped fractions of synthetic surfaces for seeds 1 .. \a
 * seeds. */
void
printCoverage(std::size_t seeds);

/** \brief CPU time for one view compared with greedy projection, median of interleaved
 * rounds. */
void
printTime(std::size_t rounds);

/** \brief Distance of the bunny's mesh to the model, and its boundary loops. */
void
printBunny();

} // namespace pcl::acmap::bench
