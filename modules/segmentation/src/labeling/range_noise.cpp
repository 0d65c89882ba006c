#include "labeling/range_noise.h"

#include <pcl/core/impl/quantile.h>

#include <algorithm>

namespace pcl::acmap::labeling {
namespace {

constexpr std::size_t max_samples = 40000;
constexpr std::size_t min_in_bin = 50;

/** Standard deviation of normally distributed values from the median of their absolute
 * values. */
double
scaledMedian(std::vector<double>& values)
{
  return 1.4826 * medianOf(values);
}

/** Calls visit (sight, plane) for a sample of those points that have only one plane
 * near. */
template <typename Visit>
void
visitSurePoints(const Survey& survey, const CandidateGrid& grid, const Visit& visit)
{
  const std::size_t step = survey.size() / max_samples + 1;
  for (std::size_t i = 0; i < survey.size(); i += step)
    if (survey.entry(i) >= 0 && grid[survey.entry(i)].size == 1)
      visit(survey.sight(i), static_cast<std::size_t>(grid[survey.entry(i)].planes[0]));
}

} // namespace

RangeNoise::RangeNoise(const Survey& survey,
                       const CandidateGrid& grid,
                       const std::vector<KnownPlane>& planes,
                       double max_sigma)
{
  constexpr double floor = 0.01; // relative to the edge of the grid's voxels
  squared_floor_ = std::pow(floor * grid.lattice().edge(), 2);
  std::array<std::vector<double>, bins> offs;
  visitSurePoints(survey, grid, [&](const Sight& sight, std::size_t plane) {
    const Crossing crossing(sight, planes[plane].patch);
    constexpr double frontal = 0.2;
    if (crossing.slant > frontal)
      offs[bin(sight.range)].push_back(std::abs(crossing.off) / crossing.slant);
  });
  // A bin without enough points gets the noise of the nearest bin that has enough.
  std::vector<double> all;
  for (std::size_t b = 0; b < bins; ++b) {
    all.insert(all.end(), offs[b].begin(), offs[b].end());
    sigmas_[b] = offs[b].size() >= min_in_bin ? scaledMedian(offs[b]) : -1;
  }
  const double overall = all.empty() ? 0 : scaledMedian(all);
  const std::array<double, bins> measured = sigmas_;
  for (std::size_t b = 0; b < bins; ++b) {
    if (measured[b] >= 0)
      continue;
    sigmas_[b] = overall;
    for (std::size_t away = 1; away < bins; ++away) {
      const double below = b >= away ? measured[b - away] : -1;
      const double above = b + away < bins ? measured[b + away] : -1;
      if (below < 0 && above < 0)
        continue;
      sigmas_[b] = std::max(below, above);
      break;
    }
  }
  for (double& sigma : sigmas_)
    sigma = std::min(sigma, max_sigma);
}

void
measureWarps(const Survey& survey,
             const CandidateGrid& grid,
             const RangeNoise& noise,
             double max_warp,
             std::vector<KnownPlane>& planes)
{
  std::vector<std::vector<double>> offs(planes.size()), expected(planes.size());
  visitSurePoints(survey, grid, [&](const Sight& sight, std::size_t p) {
    const Crossing crossing(sight, planes[p].patch);
    offs[p].push_back(std::abs(crossing.off));
    expected[p].push_back(noise.variance(crossing, planes[p]));
  });
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (planes[p].trust != PlaneTrust::Sure || offs[p].size() < min_in_bin)
      continue;
    const double measured = std::pow(scaledMedian(offs[p]), 2);
    const double known = medianOf(expected[p]);
    constexpr double significant = 1.5;
    if (measured > significant * known)
      planes[p].warp =
          std::min(std::hypot(planes[p].warp, std::sqrt(measured - known)), max_warp);
  }
}

} // namespace pcl::acmap::labeling
