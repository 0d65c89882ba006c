#pragma once

namespace pcl::acmap::bench {

/** \brief A simulated session of the paper's size through all stages: seconds, memory, and
 * what the map is off. */
void
printChainSize();

/** \brief A hand-held recording made into a map by the tools, with the poses that came
 * with it and with our own. */
void
printChainKitchen();

} // namespace pcl::acmap::bench
