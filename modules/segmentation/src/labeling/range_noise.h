#pragma once

#include "labeling/survey.h"

namespace pcl::acmap::labeling {

/** Noise along the ray as a function of the distance from the sensor, measured on
 * points near one plane only. If the sensor is unknown, it is the noise along the
 * normal. */
class RangeNoise {
public:
  RangeNoise(const Survey& survey,
             const CandidateGrid& grid,
             const std::vector<KnownPlane>& planes);

  /** Standard deviation along the ray, metres. */
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
  double squared_floor_ = 0; ///< minimum variance, square metres
};

/** Measures how far the points of large planes deviate from them beyond the noise of
 * their ranges: walls are warped, clouds are misregistered, and not every sensor has
 * errors along its rays only. */
void
measureWarps(const Survey& survey,
             const CandidateGrid& grid,
             const RangeNoise& noise,
             std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::labeling
