#pragma once

#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief All of ours on one thread: consolidation, mesh, voting, clustering, labels. */
FoundPlanes
findAcmapPlanes(const PlaneInput& input);

/** \brief Given the tolerance that the peers are given. */
FoundPlanes
findAcmapPlanesWithin(const PlaneInput& input);

} // namespace pcl::acmap::bench
