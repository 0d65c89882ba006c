#pragma once

#include "planes/plane_region.h"

namespace pcl::acmap::planes {

/** Owner of what lies on curved surfaces. */
inline constexpr std::int32_t curved_surface = -2;

/** Is the region a piece of a curved surface? It is when it bends as far as its limits let
 * it, and ends where the surface goes on beyond them. */
bool
isCurved(const CellGraph& graph,
         const std::vector<std::int32_t>& members,
         const std::vector<std::int32_t>& owner,
         const PlaneRegion& region,
         double cosine);

} // namespace pcl::acmap::planes
