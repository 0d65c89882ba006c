#pragma once

#include "planes/plane_region.h"

namespace pcl::acmap::planes {

/** Owner of hypotheses on curved surfaces. */
inline constexpr std::int32_t curved_surface = -2;

/** Is the region a part of a curved surface? It is if it bends by as much as its limits
 * permit, and ends where the surface continues beyond them. */
bool
isCurved(const CellGraph& graph,
         const std::vector<std::int32_t>& members,
         const std::vector<std::int32_t>& owner,
         const PlaneRegion& region,
         double cosine);

} // namespace pcl::acmap::planes
