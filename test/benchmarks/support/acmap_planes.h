#pragma once

#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief All stages of acmap on one thread: consolidation, mesh, voting, clustering,
 * labels. */
FoundPlanes
findAcmapPlanes(const PlaneInput& input);

/** \brief As above, with the tolerance that the peers get. */
FoundPlanes
findAcmapPlanesWithin(const PlaneInput& input);

} // namespace pcl::acmap::bench
