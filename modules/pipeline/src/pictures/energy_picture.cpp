#include "pictures/drawing.h"

#include <pcl/pipeline/rectification_pictures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace pcl {

namespace acmap {

namespace {

const std::array<Color, 6> search_colors = {blue,
                                            red,
                                            Color(30, 140, 60),
                                            Color(190, 120, 0),
                                            Color(120, 60, 170),
                                            Color(0, 140, 150)};

/** Are the energies of both the same function of the poses? This holds only within one
 * search and bin size. */
bool
areComparable(const RectificationStep& a, const RectificationStep& b)
{
  return a.search == b.search && a.bin_size == b.bin_size;
}

/** Energy of each step above the minimum of the comparable steps; NaN if it is not
 * finite. */
std::vector<double>
energiesAboveLowest(const std::vector<RectificationStep>& steps)
{
  std::map<std::pair<std::string, double>, double> lowest;
  for (const RectificationStep& step : steps)
    if (std::isfinite(step.energy)) {
      double& minimum =
          lowest.try_emplace({step.search, step.bin_size}, step.energy).first->second;
      minimum = std::min(minimum, step.energy);
    }
  std::vector<double> heights;
  for (const RectificationStep& step : steps)
    heights.push_back(std::isfinite(step.energy)
                          ? step.energy - lowest.at({step.search, step.bin_size})
                          : std::numeric_limits<double>::quiet_NaN());
  return heights;
}

/** Range of energies in a picture. */
struct EnergyRange {
  double minimum, maximum;
};

/** A range that includes 0 and all but the highest values.
 * \param[in] heights of energiesAboveLowest */
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
  const double maximum = heights[heights.size() - 1 - left_out];
  const double spare = std::max(0.05 * maximum, 1e-6);
  return {-0.5 * spare, maximum + spare};
}

} // namespace

} // namespace acmap

RgbImage
energyPicture(const std::vector<RectificationStep>& steps)
{
  constexpr int width = 885, height = 476; // pixels
  const auto last = static_cast<double>(std::max<std::size_t>(steps.size(), 2) - 1);
  const std::vector<double> heights = acmap::energiesAboveLowest(steps);
  const acmap::EnergyRange range = acmap::shownRange(heights);
  acmap::Plot plot(
      {width, height},
      {Eigen::Vector2d(0, range.minimum), Eigen::Vector2d(last, range.maximum)},
      "steps of the search",
      "energy above the lowest");
  std::vector<std::string> searches;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const RectificationStep& step = steps[i];
    const auto found = std::find(searches.begin(), searches.end(), step.search);
    const auto number = static_cast<std::size_t>(found - searches.begin());
    const acmap::Color& color =
        acmap::search_colors[number % acmap::search_colors.size()];
    if (found == searches.end()) {
      searches.push_back(step.search);
      plot.addToLegend(step.search, color);
    }
    const Eigen::Vector2d to = plot.pixelOf(static_cast<double>(i), heights[i]);
    if (i > 0 && acmap::areComparable(steps[i - 1], step))
      acmap::drawLine(plot.inside(),
                      plot.pixelOf(static_cast<double>(i - 1), heights[i - 1]),
                      to,
                      2,
                      color);
    else
      acmap::drawDot(plot.inside(), to, 3, color);
  }
  return plot.picture();
}

} // namespace pcl
