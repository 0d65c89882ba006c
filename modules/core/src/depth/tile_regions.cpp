#include "depth/tile_regions.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::depth {

namespace {

constexpr std::int32_t nobody = -1;
constexpr double fewest_share = 0.25; // of the pixels of a tile that may join a plane

/** A block of tiles that is planar. */
struct Seed {
  double rms;
  std::uint32_t column, row;
};

class RegionGrower {
public:
  RegionGrower(const TileMoments& tiles, const PixelDeviation& deviation)
  : tiles_(tiles)
  , pixels_per_tile_(static_cast<double>(tiles.edge() * tiles.edge()))
  , deviation_(deviation)
  , owner_(tiles.size(), nobody)
  {}

  void
  growFrom(std::size_t block, std::size_t stride, double flatness)
  {
    for (const Seed& seed : seedsOf(block, stride, flatness))
      if (isFree(seed, block))
        grow(seed, block);
  }

  std::vector<TileRegion>
  take()
  {
    return std::move(regions_);
  }

private:
  /** The free planar blocks, the flattest first. */
  std::vector<Seed>
  seedsOf(std::size_t block, std::size_t stride, double flatness) const
  {
    constexpr double filled = 0.9; // other blocks are at a border
    const double enough =
        filled * pixels_per_tile_ * static_cast<double>(block * block);
    std::vector<Seed> seeds;
    std::vector<Moments> of_columns(tiles_.columns());
    for (std::size_t row = 0; row + block <= tiles_.rows(); row += stride) {
      sumColumns(row, block, of_columns);
      for (std::size_t column = 0; column + block <= tiles_.columns();
           column += stride) {
        const Seed seed{
            0, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)};
        if (!isFree(seed, block))
          continue;
        Moments sum;
        for (std::size_t c = column; c < column + block; ++c)
          sum += of_columns[c];
        if (sum.count < enough)
          continue;
        const InverseFit fit = fitInverse(sum);
        if (fit.rms < flatness * deviation_.on(fit.plane, sum))
          seeds.push_back({fit.rms, seed.column, seed.row});
      }
    }
    std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
      return a.rms < b.rms;
    });
    return seeds;
  }

  /** Sums of the columns of some rows, of which blocks are made. */
  void
  sumColumns(std::size_t row, std::size_t rows, std::vector<Moments>& sums) const
  {
    for (std::size_t column = 0; column < sums.size(); ++column) {
      sums[column] = {};
      for (std::size_t r = row; r < row + rows; ++r)
        sums[column] += tiles_[r * tiles_.columns() + column];
    }
  }

  template <typename Visit>
  void
  visitBlock(const Seed& seed, std::size_t block, const Visit& visit) const
  {
    for (std::size_t row = seed.row; row < seed.row + block; ++row)
      for (std::size_t column = seed.column; column < seed.column + block; ++column)
        visit(static_cast<std::uint32_t>(row * tiles_.columns() + column));
  }

  bool
  isFree(const Seed& seed, std::size_t block) const
  {
    for (std::size_t row = seed.row; row < seed.row + block; ++row) {
      const auto first = owner_.begin() + static_cast<std::ptrdiff_t>(
                                              row * tiles_.columns() + seed.column);
      if (std::any_of(first,
                      first + static_cast<std::ptrdiff_t>(block),
                      [](std::int32_t owner) { return owner != nobody; }))
        return false;
    }
    return true;
  }

  bool
  fits(std::uint32_t tile, const InversePlane& plane) const
  {
    // maximum deviation of tiles, of real walls where pixels share noise
    constexpr double band = 1.8, shared_band = 2.4;
    const Moments& sum = tiles_[tile];
    return sum.count >= fewest_share * pixels_per_tile_ &&
           residualOf(sum, plane).rms <
               (deviation_.isIndependent() ? band : shared_band) *
                   deviation_.on(plane, sum);
  }

  void
  refit(TileRegion& region) const
  {
    region.moments = {};
    for (const std::uint32_t tile : region.tiles)
      region.moments += tiles_[tile];
    region.fit = fitInverse(region.moments);
  }

  /** Adds free tiles that are adjacent to the region, and refits the plane as it grows.
   */
  void
  spread(TileRegion& region, std::int32_t id)
  {
    constexpr double refit_growth = 1.2;
    double refit_at = refit_growth * static_cast<double>(region.tiles.size());
    const auto take = [&](std::size_t tile) {
      const auto t = static_cast<std::uint32_t>(tile);
      if (owner_[t] != nobody || !fits(t, region.fit.plane))
        return;
      owner_[t] = id;
      region.tiles.push_back(t);
      region.moments += tiles_[t];
    };
    for (std::size_t next = 0; next < region.tiles.size(); ++next) {
      const std::size_t tile = region.tiles[next];
      const std::size_t column = tile % tiles_.columns();
      if (column > 0)
        take(tile - 1);
      if (column + 1 < tiles_.columns())
        take(tile + 1);
      if (tile >= tiles_.columns())
        take(tile - tiles_.columns());
      if (tile + tiles_.columns() < tiles_.size())
        take(tile + tiles_.columns());
      if (static_cast<double>(region.tiles.size()) >= refit_at) {
        region.fit = fitInverse(region.moments);
        refit_at = refit_growth * static_cast<double>(region.tiles.size());
      }
    }
    refit(region);
  }

  /** Removes tiles that no longer fit the plane of all of them.
   * \return true if there were any */
  bool
  shed(TileRegion& region)
  {
    const std::size_t before = region.tiles.size();
    region.tiles.erase(std::remove_if(region.tiles.begin(),
                                      region.tiles.end(),
                                      [&](std::uint32_t tile) {
                                        if (fits(tile, region.fit.plane))
                                          return false;
                                        owner_[tile] = nobody;
                                        return true;
                                      }),
                       region.tiles.end());
    if (region.tiles.size() < before && !region.tiles.empty())
      refit(region);
    return region.tiles.size() < before;
  }

  void
  grow(const Seed& seed, std::size_t block)
  {
    const auto id = static_cast<std::int32_t>(regions_.size());
    TileRegion region;
    visitBlock(seed, block, [&](std::uint32_t tile) {
      region.tiles.push_back(tile);
      owner_[tile] = id;
    });
    refit(region);
    constexpr int max_rounds = 6;
    for (int round = 0; round < max_rounds; ++round) {
      const std::size_t before = region.tiles.size();
      spread(region, id);
      if (!shed(region) && region.tiles.size() == before)
        break;
    }
    constexpr std::size_t fewest_tiles = 4;
    if (region.tiles.size() >= fewest_tiles) {
      regions_.push_back(std::move(region));
      return;
    }
    for (const std::uint32_t tile : region.tiles)
      owner_[tile] = nobody;
  }

  const TileMoments& tiles_;
  double pixels_per_tile_;
  const PixelDeviation& deviation_;
  std::vector<std::int32_t> owner_;
  std::vector<TileRegion> regions_;
};

} // namespace

PixelDeviation::PixelDeviation(const DepthView& view,
                               const NoiseScale::InverseDepth& noise)
: focal_(view.focal())
, sigma_(noise.sigma())
{
  if (!noise.isIndependent())
    return;
  constexpr std::size_t cells = 256;
  const std::vector<NoiseScale::InverseDepth::AtDepth>& known = noise.by_depth;
  cells_per_unit_ = cells / known.back().inverse_depth;
  for (std::size_t cell = 0, next = 0; cell < cells; ++cell) {
    const double place = (static_cast<double>(cell) + 0.5) / cells_per_unit_;
    while (next < known.size() && known[next].inverse_depth < place)
      ++next;
    if (next == 0 || next == known.size()) {
      by_depth_.push_back(known[next == 0 ? 0 : next - 1].sigma);
      continue;
    }
    const auto &low = known[next - 1], &high = known[next];
    const double share =
        (place - low.inverse_depth) / (high.inverse_depth - low.inverse_depth);
    by_depth_.push_back(low.sigma + share * (high.sigma - low.sigma));
  }
}

double
tiltOf(const TileRegion& region, const PixelDeviation& deviation)
{
  const double pixels_of_shared_noise = deviation.isIndependent() ? 1 : 1024;
  const Moments& m = region.moments;
  const double xm = m.x / m.count, ym = m.y / m.count;
  const double xx = m.xx - m.count * xm * xm, xy = m.xy - m.count * xm * ym;
  const double yy = m.yy - m.count * ym * ym;
  const double half = (xx + yy) / 2;
  const double minimum =
      half - std::sqrt(std::max(half * half - (xx * yy - xy * xy), 0.0));
  return deviation.on(region) *
         std::sqrt(pixels_of_shared_noise / std::max(minimum, 1e-12)) /
         region.fit.plane.norm();
}

std::vector<TileRegion>
growTileRegions(const TileMoments& tiles, const PixelDeviation& deviation)
{
  RegionGrower grower(tiles, deviation);
  if (deviation.isIndependent()) { // of half the edge
    grower.growFrom(12, 2, 1.7);
    grower.growFrom(8, 2, 1.7);
  }
  grower.growFrom(6, 1, 1.7);
  grower.growFrom(4, 1, 1.7);
  grower.growFrom(3, 1, 1.7);
  grower.growFrom(2, 1, 1.2); // so few pixels may be planar by chance
  return grower.take();
}

} // namespace pcl::acmap::depth
