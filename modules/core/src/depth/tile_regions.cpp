#include "depth/tile_regions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::depth {

namespace {

constexpr std::int32_t nobody = -1;
constexpr double fewest_pixels = 16; // of a tile that may join a plane

/** A block of tiles that is a plane. */
struct Seed {
  double rms;
  std::uint32_t column, row;
};

class RegionGrower {
public:
  RegionGrower(const TileMoments& tiles, const PixelDeviation& deviation)
  : tiles_(tiles)
  , deviation_(deviation)
  , owner_(tiles.size(), nobody)
  {}

  void
  growFrom(std::size_t block, double flatness)
  {
    for (const Seed& seed : seedsOf(block, flatness))
      if (isFree(seed, block))
        grow(seed, block);
  }

  std::vector<TileRegion>
  take()
  {
    return std::move(regions_);
  }

private:
  std::vector<Seed>
  seedsOf(std::size_t block, double flatness) const
  {
    constexpr double filled = 0.3, pixels_a_tile = 64;
    const double enough = filled * pixels_a_tile * static_cast<double>(block * block);
    std::vector<Seed> seeds;
    for (std::size_t row = 0; row + block <= tiles_.rows(); ++row)
      for (std::size_t column = 0; column + block <= tiles_.columns(); ++column) {
        const Moments sum = tiles_.block(column, row, block);
        if (sum.count < enough)
          continue;
        const InverseFit fit = fitInverse(sum);
        if (fit.rms < flatness * deviation_.on(fit.plane))
          seeds.push_back({fit.rms,
                           static_cast<std::uint32_t>(column),
                           static_cast<std::uint32_t>(row)});
      }
    std::stable_sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
      return a.rms < b.rms;
    });
    return seeds;
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
    bool is_free = true;
    visitBlock(seed, block, [&](std::uint32_t tile) {
      is_free = is_free && owner_[tile] == nobody;
    });
    return is_free;
  }

  bool
  fits(std::uint32_t tile, const InversePlane& plane) const
  {
    constexpr double band = 2.4; // the most that a tile of a real wall was off
    return tiles_[tile].count >= fewest_pixels &&
           residualOf(tiles_[tile], plane).rms < band * deviation_.on(plane);
  }

  void
  refit(TileRegion& region) const
  {
    region.moments = {};
    for (const std::uint32_t tile : region.tiles)
      region.moments += tiles_[tile];
    region.fit = fitInverse(region.moments);
  }

  /** Takes in free tiles beside those of the region, fitting the plane as it grows. */
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

  /** Drops tiles that the plane of all of them no longer fits. */
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
    constexpr int most_rounds = 6;
    for (int round = 0; round < most_rounds; ++round) {
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
  PixelDeviation deviation_;
  std::vector<std::int32_t> owner_;
  std::vector<TileRegion> regions_;
};

/** How much worse a plane fits a region than its own one, 1/m. */
double
excess(const TileRegion& region, const InversePlane& plane)
{
  const double rms = residualOf(region.moments, plane).rms;
  return std::sqrt(std::max(rms * rms - region.fit.rms * region.fit.rms, 0.0));
}

/** Which regions are beside which in the picture. */
class Adjacency {
public:
  Adjacency(const TileMoments& tiles, const std::vector<TileRegion>& regions)
  : size_(regions.size())
  , borders_(size_ * size_, 0)
  {
    std::vector<std::int32_t> owner(tiles.size(), nobody);
    for (std::size_t r = 0; r < size_; ++r)
      for (const std::uint32_t tile : regions[r].tiles)
        owner[tile] = static_cast<std::int32_t>(r);
    // a tile that neither took may lie between them
    constexpr std::size_t reach = 2;
    for (std::size_t row = 0; row < tiles.rows(); ++row)
      for (std::size_t column = 0; column < tiles.columns(); ++column)
        for (std::size_t step = 1; step <= reach; ++step) {
          const std::size_t tile = row * tiles.columns() + column;
          if (column + step < tiles.columns())
            count(owner[tile], owner[tile + step]);
          if (row + step < tiles.rows())
            count(owner[tile], owner[tile + step * tiles.columns()]);
        }
  }

  bool
  touch(std::size_t a, std::size_t b) const
  {
    return borders_[a * size_ + b] > 0;
  }

  /** Region \a b became part of a. */
  void
  join(std::size_t a, std::size_t b)
  {
    for (std::size_t other = 0; other < size_; ++other)
      if (borders_[b * size_ + other] > 0 && other != a)
        borders_[a * size_ + other] = borders_[other * size_ + a] = 1;
  }

private:
  void
  count(std::int32_t a, std::int32_t b)
  {
    if (a == nobody || b == nobody || a == b)
      return;
    const auto first = static_cast<std::size_t>(a);
    const auto second = static_cast<std::size_t>(b);
    borders_[first * size_ + second] = borders_[second * size_ + first] = 1;
  }

  std::size_t size_;
  std::vector<std::uint8_t> borders_;
};

/** Do two planes look the same way as far as a region knows its tilt? */
bool
isParallel(const InversePlane& a, const InversePlane& b, double tilt)
{
  constexpr double own = 0.02, deviations = 3; // lenses bend normals by a degree
  const double allowed = own + deviations * tilt;
  return allowed > M_PI / 2 || a.normalized().dot(b.normalized()) > std::cos(allowed);
}

/** Would one plane do for both?
 * \param[in] most_excess in standard deviations */
bool
isOnePlane(const TileRegion& a,
           const TileRegion& b,
           const PixelDeviation& deviation,
           double most_excess)
{
  Moments both = a.moments;
  both += b.moments;
  const InversePlane plane = fitInverse(both).plane;
  const double most = most_excess * deviation.on(plane);
  return excess(a, plane) < most && excess(b, plane) < most &&
         isParallel(a.fit.plane, plane, tiltOf(a, deviation)) &&
         isParallel(b.fit.plane, plane, tiltOf(b, deviation));
}

/** Is the smaller region a part of the larger one that lens or matcher bend away from its
 * plane? Where they touch they are one; behind a step they are apart there too.
 * \param[in] is_of_large for each tile */
bool
isBentPart(const TileMoments& tiles,
           const TileRegion& large,
           const TileRegion& small,
           const PixelDeviation& deviation,
           const std::vector<std::uint8_t>& is_of_large)
{
  constexpr double most_share = 0.25, most_turn = 0.2; // radians
  constexpr double most_bend = 8;                      // standard deviations
  const double bend = residualOf(small.moments, large.fit.plane).rms;
  if (small.moments.count > most_share * large.moments.count ||
      large.fit.plane.normalized().dot(small.fit.plane.normalized()) <
          std::cos(most_turn) ||
      bend > most_bend * deviation.on(large.fit.plane))
    return false;
  Moments border;
  const std::size_t columns = tiles.columns();
  for (const std::uint32_t tile : small.tiles) {
    const std::size_t column = tile % columns;
    if ((column > 0 && is_of_large[tile - 1]) ||
        (column + 1 < columns && is_of_large[tile + 1]) ||
        (tile >= columns && is_of_large[tile - columns]) ||
        (tile + columns < tiles.size() && is_of_large[tile + columns]))
      border += tiles[tile];
  }
  constexpr double of_a_step = 0.65; // that much of the bend is at the border too
  return border.count > 0 &&
         std::abs(residualOf(border, large.fit.plane).mean) < of_a_step * bend;
}

void
takeIn(TileRegion& into, TileRegion& other)
{
  into.tiles.insert(into.tiles.end(), other.tiles.begin(), other.tiles.end());
  into.moments += other.moments;
  into.fit = fitInverse(into.moments);
  other.tiles.clear();
}

} // namespace

double
tiltOf(const TileRegion& region, const PixelDeviation& deviation)
{
  constexpr double pixels_of_shared_noise = 1024;
  const Moments& m = region.moments;
  const double xm = m.x / m.count, ym = m.y / m.count;
  const double xx = m.xx - m.count * xm * xm, xy = m.xy - m.count * xm * ym;
  const double yy = m.yy - m.count * ym * ym;
  const double half = (xx + yy) / 2;
  const double least =
      half - std::sqrt(std::max(half * half - (xx * yy - xy * xy), 0.0));
  return deviation.on(region.fit.plane) *
         std::sqrt(pixels_of_shared_noise / std::max(least, 1e-12)) /
         region.fit.plane.norm();
}

std::vector<TileRegion>
growTileRegions(const TileMoments& tiles, const PixelDeviation& deviation)
{
  RegionGrower grower(tiles, deviation);
  grower.growFrom(6, 1.7);
  grower.growFrom(4, 1.7);
  grower.growFrom(3, 1.7);
  grower.growFrom(2, 1.2); // so few pixels are planes by chance
  return grower.take();
}

std::size_t
mergeTileRegions(const TileMoments& tiles,
                 const PixelDeviation& deviation,
                 std::vector<TileRegion>& regions)
{
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.moments.count > b.moments.count;
  });
  Adjacency adjacency(tiles, regions);
  // the lens and long waves of the matcher bend the parts of one wall apart
  constexpr double excess_of_neighbours = 2.2, excess_of_others = 1.2;
  constexpr double sure_tilt = 0.05; // radians
  std::size_t merged = 0;
  const auto mergeAll = [&](const auto& may_merge, double most_excess) {
    for (std::size_t before = merged + 1; before != merged;) {
      before = merged;
      for (std::size_t i = 0; i < regions.size(); ++i)
        for (std::size_t j = i + 1; j < regions.size(); ++j)
          if (!regions[i].tiles.empty() && !regions[j].tiles.empty() &&
              may_merge(i, j) &&
              isOnePlane(regions[i], regions[j], deviation, most_excess)) {
            takeIn(regions[i], regions[j]);
            adjacency.join(i, j);
            ++merged;
          }
    }
  };
  mergeAll([&](std::size_t i, std::size_t j) { return adjacency.touch(i, j); },
           excess_of_neighbours);
  std::vector<std::uint8_t> is_of_large(tiles.size(), 0);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (const std::uint32_t tile : regions[i].tiles)
      is_of_large[tile] = 1;
    for (std::size_t j = i + 1; j < regions.size(); ++j)
      if (!regions[i].tiles.empty() && !regions[j].tiles.empty() &&
          adjacency.touch(i, j) &&
          isBentPart(tiles, regions[i], regions[j], deviation, is_of_large)) {
        for (const std::uint32_t tile : regions[j].tiles)
          is_of_large[tile] = 1;
        takeIn(regions[i], regions[j]);
        adjacency.join(i, j);
        ++merged;
      }
    for (const std::uint32_t tile : regions[i].tiles)
      is_of_large[tile] = 0;
  }
  // scraps that lie in one plane by chance are none
  mergeAll([&](std::size_t i,
               std::size_t) { return tiltOf(regions[i], deviation) < sure_tilt; },
           excess_of_others);
  regions.erase(std::remove_if(regions.begin(),
                               regions.end(),
                               [](const TileRegion& r) { return r.tiles.empty(); }),
                regions.end());
  return merged;
}

} // namespace pcl::acmap::depth
