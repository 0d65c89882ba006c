#pragma once

namespace pcl::acmap {

/** \brief From now on, the first interruption (SIGINT, SIGTERM, SIGHUP) is only
 * recorded, so that the tool can stop cleanly; the second one ends it at once. */
void
noteInterruptions();

/** \brief From now on, an interruption ends the tool at once, as usual. */
void
obeyInterruptions();

/** \brief Was there an interruption? */
bool
interrupted();

} // namespace pcl::acmap
