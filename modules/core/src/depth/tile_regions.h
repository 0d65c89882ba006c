#pragma once

#include "depth/tile_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

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
  PixelDeviation(const DepthView& view, const NoiseScale::InverseDepth& noise);

  /** Is it independent between pixels? */
  bool
  isIndependent() const
  {
    return !by_depth_.empty();
  }

  /** Standard deviation on a plane at an inverse depth, both 1/m. Noise that pixels share
   * comes from the matching window, or the filter of the camera, which also cause an error
   * of the image position of a measurement. */
  double
  on(const InversePlane& plane, double inverse_depth) const
  {
    return isIndependent() ? at(inverse_depth) : onSlanted(plane);
  }

  /** On the plane of a region, at its mean inverse depth. */
  double
  on(const TileRegion& region) const
  {
    return on(region.fit.plane, region.moments);
  }

  double
  on(const InversePlane& plane, const Moments& moments) const
  {
    return on(plane, moments.z / moments.count);
  }

private:
  double
  at(double inverse_depth) const
  {
    const double cell = inverse_depth * cells_per_unit_;
    const double last = static_cast<double>(by_depth_.size() - 1);
    return by_depth_[static_cast<std::size_t>(std::clamp(cell, 0.0, last))];
  }

  double
  onSlanted(const InversePlane& plane) const
  {
    constexpr double misplaced = 0.6; // pixels; the same for a Kinect and for stereo
    constexpr double maximum = 2;     // steeper slopes are depth edges
    const double slope = plane.head<2>().cwiseQuotient(focal_).norm();
    const double off = std::min(misplaced * slope, maximum * sigma_);
    return std::sqrt(sigma_ * sigma_ + off * off);
  }

  Eigen::Vector2d focal_;
  double sigma_;                 ///< on a frontal plane, 1/m
  std::vector<double> by_depth_; ///< in even cells of inverse depth from 0; or empty
  double cells_per_unit_ = 0;    ///< metres
};

/** Standard deviation of the tilt of the plane in radians. Noise that is not independent
 * is assumed to be shared by pixels up to 32 apart. */
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
