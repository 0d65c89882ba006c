#pragma once

#include "labeling/survey.h"

#include <cstring>

namespace pcl::acmap::labeling {

/** Noise along the ray as a function of the distance from the sensor, measured on
 * points near one plane only. If the sensor is unknown, it is the noise along the
 * normal. */
class RangeNoise {
public:
  RangeNoise(const Survey& survey,
             const CandidateGrid& grid,
             const std::vector<KnownPlane>& planes,
             double max_sigma);

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

  // Two bins per octave, from 6 cm to a megametre; bin 0 for unknown ranges. The bin is
  // computed from the bits of the number: half an octave is the fraction 0x6a09e667f3bcd.
  [[gnu::always_inline]] static std::size_t
  bin(double range)
  {
    if (!(range > 0))
      return 0;
    std::uint64_t bits;
    std::memcpy(&bits, &range, sizeof bits);
    constexpr std::uint64_t fraction_mask = (std::uint64_t{1} << 52) - 1;
    constexpr std::uint64_t root_of_two = 0x6a09e667f3bcd;
    const int octave = static_cast<int>(bits >> 52) - 1022;
    const bool is_upper = (bits & fraction_mask) >= root_of_two;
    const int place = 2 * octave + (is_upper ? 8 : 7);
    return static_cast<std::size_t>(std::clamp(place, 1, static_cast<int>(bins) - 1));
  }

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
             double max_warp,
             std::vector<KnownPlane>& planes);

} // namespace pcl::acmap::labeling
