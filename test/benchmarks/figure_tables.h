#pragma once

#include <cstddef>

namespace pcl::acmap::bench {

/** \brief Faults and yield of both rules and of greedy projection on the real clouds. */
void
printSoundness();

/** \brief Uncovered and overlapped shares of synthetic surfaces over seeds 1 .. \a seeds. */
void
printCoverage(std::size_t seeds);

/** \brief CPU time of one view beside greedy projection, median of interleaved rounds. */
void
printTime(std::size_t rounds);

/** \brief Distance of the bunny's mesh to the model, and its boundary loops. */
void
printBunny();

} // namespace pcl::acmap::bench
