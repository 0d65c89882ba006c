#pragma once

#include "outlines/sight_rays.h"

namespace pcl::acmap::outlines {

/** Sets PlanePatch::proposed of planes whose polygons are known: where a plane was not
 * seen, no sensor looked through, and its own outline encloses it.
 *
 * A hole is enclosed. So is a bay, a part of the outer boundary between two edges that
 * continue each other along one line, or that are creases whose lines meet in a corner.
 * The boundary of both consists of frontiers; it may also have creases if another plane
 * that faces the same way is in front, as the front of a cupboard on a wall: what is
 * beyond other creases is outside of the room. */
void
proposeSurfaces(const SightRays& rays,
                const std::vector<PlaneRaster>& rasters,
                KnownPlanes& known);

} // namespace pcl::acmap::outlines
