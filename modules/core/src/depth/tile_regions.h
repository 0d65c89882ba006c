#pragma once

#include "depth/tile_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl::acmap::depth {

/** A plane over tiles of a view. */
struct TileRegion {
  std::vector<std::uint32_t> tiles;
  Moments moments;
  InverseFit fit;
};

/** How far pixels of a plane are off it in inverse depth. */
class PixelDeviation {
public:
  PixelDeviation(const DepthView& view, double sigma)
  : focal_(view.focal())
  , sigma_(sigma)
  {}

  /** Standard deviation on a plane that is faced, 1/m. */
  double
  sigma() const
  {
    return sigma_;
  }

  /** The same on a slanted one: the window that is matched, or the camera's filter, also
   * misplaces a measurement in the picture. */
  double
  on(const InversePlane& plane) const
  {
    constexpr double misplaced = 0.6; // pixels; the same for a Kinect and for stereo
    constexpr double most = 2;        // so steep are depth edges only
    const double slope = plane.head<2>().cwiseQuotient(focal_).norm();
    const double off = std::min(misplaced * slope, most * sigma_);
    return std::sqrt(sigma_ * sigma_ + off * off);
  }

private:
  Eigen::Vector2d focal_;
  double sigma_;
};

/** Standard deviation of the plane's tilt in radians, where pixels up to 32 apart share
 * their noise. */
double
tiltOf(const TileRegion& region, const PixelDeviation& deviation);

/** Grows planes over the tiles of a view, the largest seeds first. */
std::vector<TileRegion>
growTileRegions(const TileMoments& tiles, const PixelDeviation& deviation);

/** Joins regions of one plane: neighbours first, then those that lie apart.
 * \return number of regions that were taken in */
std::size_t
mergeTileRegions(const TileMoments& tiles,
                 const PixelDeviation& deviation,
                 std::vector<TileRegion>& regions);

/** Drops regions that are strips of a curved surface: they are bent, and the surface goes
 * on smoothly where they end. \return their number */
std::size_t
dropCurvedRegions(const TileMoments& tiles,
                  const PixelDeviation& deviation,
                  std::vector<TileRegion>& regions);

} // namespace pcl::acmap::depth
