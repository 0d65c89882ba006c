#pragma once

namespace pcl::acmap::bench {

/** \brief A simulated session of the paper's size through all stages: time, memory, and
 * errors of the map. */
void
printChainSize();

/** \brief A hand-held recording that the tools turn into a map, with the given and with
 * estimated poses. */
void
printChainKitchen();

} // namespace pcl::acmap::bench
