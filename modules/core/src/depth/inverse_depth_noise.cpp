#include "depth/tile_moments.h"

#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** Lower quartile of the rms of the residuals of full tiles about their planes, 1/m; 0
 * if there are too few tiles. Tiles with objects and edges have a larger rms. */
double
flatTiles(const DepthView& view, std::size_t edge)
{
  constexpr double full = 0.9;
  constexpr std::size_t fewest = 8;
  const depth::TileMoments tiles(view, edge);
  const double pixels = static_cast<double>(edge * edge);
  std::vector<double> deviations;
  for (std::size_t t = 0; t < tiles.size(); ++t)
    if (tiles[t].count >= full * pixels)
      deviations.push_back(depth::fitInverse(tiles[t]).rms *
                           std::sqrt(tiles[t].count / (tiles[t].count - 3)));
  if (deviations.size() < fewest)
    return 0;
  return quantileOf(deviations, 0.25);
}

} // namespace

NoiseScale::InverseDepth
measureInverseDepthNoise(const DepthView& view, double step)
{
  NoiseScale::InverseDepth noise;
  noise.step = step;
  const double rounding = step / std::sqrt(12.0);
  noise.independent = std::max(flatTiles(view, 4), rounding);
  const double middle = flatTiles(view, 8);
  // without large planar tiles, the small ones limit how far the noise may grow
  constexpr double largest_growth = 2.5;
  double all = flatTiles(view, 32);
  if (all == 0 || (middle > 0 && all > largest_growth * middle))
    all = largest_growth * middle;
  noise.correlated =
      std::sqrt(std::max(all * all - noise.independent * noise.independent, 0.0));
  return noise;
}

} // namespace pcl::acmap
