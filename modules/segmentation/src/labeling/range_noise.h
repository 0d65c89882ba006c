#pragma once

#include "labeling/survey.h"

namespace pcl::acmap::labeling {

/** Noise along the ray by distance from the sensor, measured on points near one plane
 * only; across the surface where no sensor is known. */
class RangeNoise {
public:
  RangeNoise(const Survey& survey,
             const CandidateGrid& grid,
             const std::vector<KnownPlane>& planes);

  /** Metres. */
  double
  sigma(double range) const
  {
    return sigmas_[bin(range)];
  }

  /** Variance of a point's distance from a plane, square metres. */
  double
  variance(const Crossing& crossing, const KnownPlane& plane) const
  {
    const double across = sigma(crossing.range) * crossing.slant;
    return across * across + plane.warp * plane.warp + squared_floor_;
  }

private:
  static constexpr std::size_t bins = 48;

  static std::size_t
  bin(double range);

  std::array<double, bins> sigmas_{};
  double squared_floor_ = 0; ///< what no surface is flatter than, square metres
};

/** What the points of large planes are off them beyond the noise of their ranges: walls are
 * warped, clouds laid double, and not every sensor errs along its rays only. */
void
measureWarps(const Survey& survey,
             const CandidateGrid& grid,
             const RangeNoise& noise,
             std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::labeling
