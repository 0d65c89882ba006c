#include "consolidation/noise_profile.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

using Samples = std::vector<PlaneNoise>;

/** \brief Returns false if there is no range, or if its square overflowed. */
bool
isKnown(double range)
{
  return range > 0 && std::isfinite(range);
}

int
binOf(double range)
{
  return static_cast<int>(std::floor(2 * std::log2(range)));
}

double
slopeOf(const PlaneNoise& plane)
{
  return plane.thickness / plane.height;
}

template <typename Value>
double
medianOf(Samples::iterator begin, Samples::iterator end, const Value& value)
{
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](const auto& a, const auto& b) {
    return value(a) < value(b);
  });
  return value(*middle);
}

} // namespace

NoiseProfile::NoiseProfile(Samples& samples)
{
  if (samples.empty())
    return;
  thickness_ = medianOf(samples.begin(), samples.end(), [](const PlaneNoise& plane) {
    return plane.thickness;
  });
  slope_ = medianOf(samples.begin(), samples.end(), slopeOf);
  const auto known =
      std::partition(samples.begin(), samples.end(), [](const PlaneNoise& s) {
        return !isKnown(s.range);
      });
  std::sort(known, samples.end(), [](const PlaneNoise& a, const PlaneNoise& b) {
    return a.range < b.range;
  });
  constexpr std::ptrdiff_t enough = 50;
  for (auto begin = known; begin != samples.end();) {
    const int bin = binOf(begin->range);
    const auto end = std::find_if(begin, samples.end(), [bin](const PlaneNoise& s) {
      return binOf(s.range) != bin;
    });
    if (slopes_.empty())
      first_bin_ = bin;
    slopes_.resize(static_cast<std::size_t>(bin - first_bin_) + 1, slope_);
    if (end - begin >= enough)
      slopes_.back() = medianOf(begin, end, slopeOf);
    begin = end;
  }
}

double
NoiseProfile::expectedThickness(const PlaneNoise& plane) const
{
  if (slopes_.empty() || !isKnown(plane.range))
    return slope_ * plane.height;
  const int last = static_cast<int>(slopes_.size()) - 1;
  const int bin = std::clamp(binOf(plane.range) - first_bin_, 0, last);
  return slopes_[static_cast<std::size_t>(bin)] * plane.height;
}

} // namespace pcl::acmap
