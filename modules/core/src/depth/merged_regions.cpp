#include "depth/tile_regions.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::depth {

namespace {

/** Additional rms of a region about a plane that is not its own one, 1/m. */
double
excess(const TileRegion& region, const InversePlane& plane)
{
  const double rms = residualOf(region.moments, plane).rms;
  return std::sqrt(std::max(rms * rms - region.fit.rms * region.fit.rms, 0.0));
}

/** Adjacency of regions in the image. */
class Adjacency {
public:
  Adjacency(const TileMoments& tiles, const std::vector<TileRegion>& regions)
  : size_(regions.size())
  , borders_(size_ * size_, 0)
  {
    constexpr std::int32_t nobody = -1;
    std::vector<std::int32_t> owner(tiles.size(), nobody);
    for (std::size_t r = 0; r < size_; ++r)
      for (const std::uint32_t tile : regions[r].tiles)
        owner[tile] = static_cast<std::int32_t>(r);
    // a tile that belongs to neither region may be between them
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

  /** Region \a b was merged into \a a. */
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
    if (a < 0 || b < 0 || a == b)
      return;
    const auto first = static_cast<std::size_t>(a);
    const auto second = static_cast<std::size_t>(b);
    borders_[first * size_ + second] = borders_[second * size_ + first] = 1;
  }

  std::size_t size_;
  std::vector<std::uint8_t> borders_;
};

/** Are two planes parallel within the uncertainty of the tilt of a region? */
bool
isParallel(const InversePlane& a, const InversePlane& b, double tilt)
{
  // lens distortion tilts normals by a degree
  constexpr double own = 0.02, deviations = 3;
  const double allowed = own + deviations * tilt;
  return allowed > M_PI / 2 || a.normalized().dot(b.normalized()) > std::cos(allowed);
}

/** Do both regions fit a common plane?
 * \param[in] max_excess in standard deviations */
bool
isOnePlane(const TileRegion& a,
           const TileRegion& b,
           const PixelDeviation& deviation,
           double max_excess)
{
  Moments both = a.moments;
  both += b.moments;
  const InversePlane plane = fitInverse(both).plane;
  const double maximum = max_excess * deviation.on(plane, both);
  return excess(a, plane) < maximum && excess(b, plane) < maximum &&
         isParallel(a.fit.plane, plane, tiltOf(a, deviation)) &&
         isParallel(b.fit.plane, plane, tiltOf(b, deviation));
}

/** Is the smaller region a part of the larger one whose depth was distorted by the lens
 * or by stereo matching? Such regions coincide at their common border, whereas regions
 * at different depths are apart there too.
 * \param[in] is_of_large for each tile */
bool
isBentPart(const TileMoments& tiles,
           const TileRegion& large,
           const TileRegion& small,
           const PixelDeviation& deviation,
           const std::vector<std::uint8_t>& is_of_large)
{
  constexpr double max_share = 0.25, max_turn = 0.2; // radians
  constexpr double max_bend = 14;                    // standard deviations
  const double bend = residualOf(small.moments, large.fit.plane).rms;
  if (small.moments.count > max_share * large.moments.count ||
      large.fit.plane.normalized().dot(small.fit.plane.normalized()) <
          std::cos(max_turn) ||
      bend > max_bend * deviation.on(large.fit.plane, small.moments))
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
  // maximum share of the deviation that is present at the border
  constexpr double of_a_step = 0.75;
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

std::size_t
mergeTileRegions(const TileMoments& tiles,
                 const PixelDeviation& deviation,
                 std::vector<TileRegion>& regions)
{
  std::stable_sort(regions.begin(), regions.end(), [](const auto& a, const auto& b) {
    return a.moments.count > b.moments.count;
  });
  Adjacency adjacency(tiles, regions);
  // the parts of one wall deviate due to the lens and to low-frequency errors of the
  // matcher
  constexpr double excess_of_neighbours = 2.2, excess_of_others = 1.2;
  constexpr double sure_tilt = 0.05; // radians
  std::size_t merged = 0;
  const auto mergeAll = [&](const auto& may_merge, double max_excess) {
    for (std::size_t before = merged + 1; before != merged;) {
      before = merged;
      for (std::size_t i = 0; i < regions.size(); ++i)
        for (std::size_t j = i + 1; j < regions.size(); ++j)
          if (!regions[i].tiles.empty() && !regions[j].tiles.empty() &&
              may_merge(i, j) &&
              isOnePlane(regions[i], regions[j], deviation, max_excess)) {
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
  // small regions may be in one plane by chance and are not merged
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
