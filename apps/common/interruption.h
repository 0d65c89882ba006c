#pragma once

namespace pcl::acmap {

/** \brief From now on an interruption (Ctrl-C, a polite kill, a lost terminal) is only
 * noted, so that the tool can stop cleanly; the second one ends it at once. */
void
noteInterruptions();

/** \brief From now on an interruption ends the tool at once, as it does any program. */
void
obeyInterruptions();

/** \brief Whether one has come. */
bool
interrupted();

} // namespace pcl::acmap
