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
  variance(const Crossing& crossing) const
  {
    const double across = sigma(crossing.range) * crossing.slant;
    return across * across + squared_floor_;
  }

private:
  static constexpr std::size_t bins = 48;

  static std::size_t
  bin(double range);

  std::array<double, bins> sigmas_{};
  double squared_floor_ = 0; ///< what no surface is flatter than, square metres
};

} // namespace pcl::acmap::labeling
