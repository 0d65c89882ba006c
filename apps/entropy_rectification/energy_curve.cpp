#include "energy_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace pcl::acmap {

bool
areComparable(const RectificationStep& a, const RectificationStep& b)
{
  return a.search == b.search && a.bin_size == b.bin_size;
}

std::vector<double>
energiesAboveLowest(const std::vector<RectificationStep>& steps)
{
  std::map<std::pair<std::string, double>, double> lowest;
  for (const RectificationStep& step : steps)
    if (std::isfinite(step.energy)) {
      double& least =
          lowest.try_emplace({step.search, step.bin_size}, step.energy).first->second;
      least = std::min(least, step.energy);
    }
  std::vector<double> heights;
  for (const RectificationStep& step : steps)
    heights.push_back(std::isfinite(step.energy)
                          ? step.energy - lowest.at({step.search, step.bin_size})
                          : std::numeric_limits<double>::quiet_NaN());
  return heights;
}

EnergyRange
shownRange(std::vector<double> heights)
{
  heights.erase(std::remove_if(heights.begin(),
                               heights.end(),
                               [](double height) { return std::isnan(height); }),
                heights.end());
  if (heights.empty())
    return {0, 1};
  std::sort(heights.begin(), heights.end());
  const std::size_t left_out = heights.size() / 40; // zero if there are few
  const double most = heights[heights.size() - 1 - left_out];
  const double spare = std::max(0.05 * most, 1e-6);
  return {-0.5 * spare, most + spare};
}

} // namespace pcl::acmap
