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

/** Deviation of the pixels of a plane in inverse depth. */
class PixelDeviation {
public:
  PixelDeviation(const DepthView& view, double sigma)
  : focal_(view.focal())
  , sigma_(sigma)
  {}

  /** Standard deviation on a frontal plane, 1/m. */
  double
  sigma() const
  {
    return sigma_;
  }

  /** Standard deviation on a slanted plane, 1/m. The matching window, or the filter of
   * the camera, also causes an error of the image position of a measurement. */
  double
  on(const InversePlane& plane) const
  {
    constexpr double misplaced = 0.6; // pixels; the same for a Kinect and for stereo
    constexpr double maximum = 2;     // steeper slopes are depth edges
    const double slope = plane.head<2>().cwiseQuotient(focal_).norm();
    const double off = std::min(misplaced * slope, maximum * sigma_);
    return std::sqrt(sigma_ * sigma_ + off * off);
  }

private:
  Eigen::Vector2d focal_;
  double sigma_;
};

/** Standard deviation of the tilt of the plane in radians, assuming that the noise is
 * correlated for pixels up to 32 apart. */
double
tiltOf(const TileRegion& region, const PixelDeviation& deviation);

/** Grows planes over the tiles of a view, starting with the largest seeds. */
std::vector<TileRegion>
growTileRegions(const TileMoments& tiles, const PixelDeviation& deviation);

/** Merges regions of the same plane: first neighbours, then regions that are apart.
 * \return number of regions that were merged into another one */
std::size_t
mergeTileRegions(const TileMoments& tiles,
                 const PixelDeviation& deviation,
                 std::vector<TileRegion>& regions);

/** Removes regions that are strips of a curved surface: they are curved, and the
 * surface continues smoothly beyond their ends.
 * \return their number */
std::size_t
dropCurvedRegions(const TileMoments& tiles,
                  const PixelDeviation& deviation,
                  std::vector<TileRegion>& regions);

} // namespace pcl::acmap::depth
