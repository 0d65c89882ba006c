#pragma once

#include "depth/tile_regions.h"

namespace pcl::acmap::depth {

inline constexpr std::int32_t no_plane = -1;

/** Assigns each pixel to a region.
 * \param[in] edge of a tile, pixels
 * \return for each pixel the index of its region, or no_plane */
std::vector<std::int32_t>
labelPixels(const DepthView& view,
            const TileMoments& tiles,
            std::size_t edge,
            const std::vector<TileRegion>& regions,
            const PixelDeviation& deviation);

} // namespace pcl::acmap::depth
