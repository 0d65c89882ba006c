#include "rgbd/depth_numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap {

void
DepthNumbers::add(const std::vector<std::uint16_t>& numbers)
{
  constexpr std::uint16_t saturated = 65535;
  for (const std::uint16_t number : numbers)
    if (number != 0 && number != saturated) {
      ++counts_[number];
      ++count_;
    }
}

int
DepthNumbers::median() const
{
  std::uint64_t left = (count_ + 1) / 2;
  std::size_t number = 0;
  while (number + 1 < counts_.size() && counts_[number] < left)
    left -= counts_[number++];
  return count_ == 0 ? 0 : static_cast<int>(number);
}

int
DepthNumbers::commonDivisor() const
{
  int divisor = 0;
  for (std::size_t number = 0; number < counts_.size(); ++number)
    if (counts_[number] > 0)
      divisor = std::gcd(divisor, static_cast<int>(number));
  return divisor;
}

std::optional<double>
DepthNumbers::scaleOfSteps() const
{
  constexpr double kinect_step = 0.00285; // step at 1 m, metres
  constexpr std::size_t min_steps = 40;
  constexpr double max_spread = 1.35; // quartiles, of steps over squares
  const auto unit = static_cast<double>(std::max(commonDivisor(), 1));
  std::vector<double> steps; // over the squares of the numbers
  double last = 0;
  for (auto number = static_cast<std::size_t>(median()); number < counts_.size();
       ++number) {
    if (counts_[number] == 0)
      continue;
    const auto here = static_cast<double>(number);
    // Steps of two units and fewer are too coarse to compare.
    if (last > 0 && here - last > 2.5 * unit)
      steps.push_back((here - last) / (here * last));
    else if (last > 0)
      steps.push_back(0);
    last = here;
  }
  if (steps.size() < min_steps)
    return std::nullopt;
  std::sort(steps.begin(), steps.end());
  const double low = steps[steps.size() / 4], high = steps[steps.size() * 3 / 4];
  if (!(low > 0 && high < max_spread * low))
    return std::nullopt;
  return kinect_step / steps[steps.size() / 2];
}

} // namespace pcl::acmap
