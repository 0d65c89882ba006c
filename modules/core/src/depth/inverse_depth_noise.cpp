#include "depth/tile_moments.h"

#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace depth {
namespace {

using AtDepth = NoiseScale::InverseDepth::AtDepth;

constexpr double full = 0.9; // of the pixels of a tile

/** Lower quartile of the rms of the residuals of full tiles about their planes, 1/m; 0
 * if there are too few tiles. Tiles with objects and edges have a larger rms. */
double
flatTiles(const TileMoments& tiles, std::size_t edge)
{
  constexpr std::size_t fewest = 8;
  const double pixels = static_cast<double>(edge * edge);
  std::vector<double> deviations;
  for (std::size_t t = 0; t < tiles.size(); ++t)
    if (tiles[t].count >= full * pixels)
      deviations.push_back(fitInverse(tiles[t]).rms *
                           std::sqrt(tiles[t].count / (tiles[t].count - 3)));
  if (deviations.size() < fewest)
    return 0;
  return quantileOf(deviations, 0.25);
}

constexpr std::size_t fine_edge = 4, coarse_edge = 8; // pixels

/** The noise of a full coarse tile. */
struct TileNoise {
  double inverse_depth; ///< mean, 1/m
  double variance;      ///< about its plane
  double of_quarters;   ///< of its four fine tiles about their own planes
};

std::vector<TileNoise>
noiseOfTiles(const TileMoments& fine, const TileMoments& coarse)
{
  constexpr double pixels = coarse_edge * coarse_edge, parameters = 3;
  std::vector<TileNoise> noises;
  for (std::size_t row = 0; 2 * row + 1 < fine.rows(); ++row)
    for (std::size_t column = 0; 2 * column + 1 < fine.columns(); ++column) {
      const Moments& whole = coarse[row * coarse.columns() + column];
      if (whole.count < full * pixels)
        continue;
      double squares = 0, freedom = 0;
      for (const std::size_t r : {2 * row, 2 * row + 1})
        for (const std::size_t c : {2 * column, 2 * column + 1}) {
          const Moments& quarter = fine[r * fine.columns() + c];
          if (quarter.count <= parameters)
            continue;
          const double rms = fitInverse(quarter).rms;
          squares += rms * rms * quarter.count;
          freedom += quarter.count - parameters;
        }
      const double rms = fitInverse(whole).rms;
      noises.push_back({whole.z / whole.count,
                        rms * rms * whole.count / (whole.count - parameters),
                        squares / freedom});
    }
  std::sort(noises.begin(), noises.end(), [](const TileNoise& a, const TileNoise& b) {
    return a.inverse_depth < b.inverse_depth;
  });
  return noises;
}

/** Lowers what objects and edges have raised: in metres, noise does not fall with the
 * depth, and it does not grow faster than that of triangulation. */
void
lowerToSensors(std::vector<AtDepth>& noise)
{
  const auto in_metres = [](const AtDepth& at, double sigma) {
    return sigma / (at.inverse_depth * at.inverse_depth);
  };
  const std::vector<AtDepth> measured = noise;
  double least = measured.back().sigma;
  for (std::size_t i = noise.size(); i-- > 0;) {
    least = std::min(least, measured[i].sigma);
    noise[i].sigma = least;
  }
  least = in_metres(measured.front(), measured.front().sigma);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    least = std::min(least, in_metres(measured[i], measured[i].sigma));
    noise[i].sigma = std::min(noise[i].sigma,
                              least * noise[i].inverse_depth * noise[i].inverse_depth);
  }
}

/** The noise by depth if it is independent between pixels: then planes of large tiles
 * leave no more of it than those of small ones. Otherwise, and of too few tiles, nothing.
 */
std::vector<AtDepth>
noiseByDepth(const TileMoments& fine, const TileMoments& coarse)
{
  constexpr std::size_t tiles_per_depth = 64, max_depths = 16;
  constexpr double max_shared = 1.06; // variance of large tiles over that of small ones
  constexpr double of_quartile = 0.94; // lower quartile of the rms of 61 residuals
  // of the depth: below is the rounding of floats, above there is no surface
  constexpr double rounding = 1e-6, max_noise = 0.05;
  std::vector<TileNoise> noises = noiseOfTiles(fine, coarse);
  const std::size_t depths = std::min(noises.size() / tiles_per_depth, max_depths);
  std::vector<AtDepth> by_depth;
  std::vector<double> ratios;
  for (std::size_t d = 0; d < depths; ++d) {
    const auto begin =
        noises.begin() + static_cast<std::ptrdiff_t>(noises.size() * d / depths);
    const auto end =
        noises.begin() + static_cast<std::ptrdiff_t>(noises.size() * (d + 1) / depths);
    const double inverse_depth = (begin + (end - begin) / 2)->inverse_depth;
    const auto quarter = begin + (end - begin) / 4, half = begin + (end - begin) / 2;
    std::sort(begin, end, [](const TileNoise& a, const TileNoise& b) {
      return a.variance < b.variance;
    });
    for (auto tile = begin; tile != half; ++tile)
      ratios.push_back(tile->variance / tile->of_quarters);
    by_depth.push_back({inverse_depth, std::sqrt(quarter->variance) / of_quartile});
    if (!(by_depth.back().sigma > rounding * inverse_depth))
      return {};
  }
  if (by_depth.empty() || !(medianOf(ratios) < max_shared))
    return {};
  lowerToSensors(by_depth);
  const bool is_surface =
      std::all_of(by_depth.begin(), by_depth.end(), [](const AtDepth& at) {
        return at.sigma < max_noise * at.inverse_depth;
      });
  return is_surface ? by_depth : std::vector<AtDepth>();
}

} // namespace
} // namespace depth

NoiseScale::InverseDepth
measureInverseDepthNoise(const DepthView& view, double step)
{
  using namespace depth;
  constexpr std::size_t largest_edge = 32;
  NoiseScale::InverseDepth noise;
  noise.step = step;
  const double rounding = step / std::sqrt(12.0);
  const TileMoments fine(view, fine_edge), coarse(view, coarse_edge);
  noise.independent = std::max(flatTiles(fine, fine_edge), rounding);
  const double middle = flatTiles(coarse, coarse_edge);
  // without large planar tiles, the small ones limit how far the noise may grow
  constexpr double largest_growth = 2.5;
  double all = flatTiles(TileMoments(view, largest_edge), largest_edge);
  if (all == 0 || (middle > 0 && all > largest_growth * middle))
    all = largest_growth * middle;
  noise.correlated =
      std::sqrt(std::max(all * all - noise.independent * noise.independent, 0.0));
  if (step == 0)
    noise.by_depth = noiseByDepth(fine, coarse);
  return noise;
}

} // namespace pcl::acmap
