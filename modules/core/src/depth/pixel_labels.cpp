#include "depth/pixel_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap::depth {

namespace {

/** Type of the edge between two planes, as seen from the sensor. */
enum class Junction : std::int8_t {
  None,
  Inner, ///< concave: the front plane is visible, e.g. wall and floor
  Outer  ///< convex: the rear plane is visible, e.g. two faces of a box
};

/** Planes near each tile, and types of the edges between planes. */
class PlaneNeighbourhood {
public:
  static constexpr std::size_t most = 6;

  struct Near {
    std::array<std::int32_t, most> planes;
    std::size_t size = 0;

    void
    add(std::int32_t plane)
    {
      if (plane == no_plane || size == most ||
          std::find(planes.begin(), planes.begin() + size, plane) !=
              planes.begin() + size)
        return;
      planes[size++] = plane;
    }
  };

  PlaneNeighbourhood(const TileMoments& tiles, const std::vector<TileRegion>& regions)
  : near_(tiles.size())
  , planes_(regions.size())
  , junctions_(regions.size() * regions.size(), Junction::None)
  {
    std::vector<std::int32_t> owner(tiles.size(), no_plane);
    for (std::size_t r = 0; r < regions.size(); ++r)
      for (const std::uint32_t tile : regions[r].tiles)
        owner[tile] = static_cast<std::int32_t>(r);
    for (std::size_t tile = 0; tile < tiles.size(); ++tile)
      collect(tiles, owner, tile);
    for (std::size_t a = 0; a < planes_; ++a)
      for (std::size_t b = a + 1; b < planes_; ++b)
        junctions_[a * planes_ + b] = junctions_[b * planes_ + a] =
            meet(tiles, regions[a], regions[b]);
  }

  const Near&
  operator[](std::size_t tile) const
  {
    return near_[tile];
  }

  Junction
  between(std::int32_t a, std::int32_t b) const
  {
    return junctions_[static_cast<std::size_t>(a) * planes_ +
                      static_cast<std::size_t>(b)];
  }

private:
  void
  collect(const TileMoments& tiles,
          const std::vector<std::int32_t>& owner,
          std::size_t tile)
  {
    const std::size_t column = tile % tiles.columns(), row = tile / tiles.columns();
    Near& near = near_[tile];
    near.add(owner[tile]);
    for (std::size_t r = row > 0 ? row - 1 : 0; r < std::min(row + 2, tiles.rows());
         ++r)
      for (std::size_t c = column > 0 ? column - 1 : 0;
           c < std::min(column + 2, tiles.columns());
           ++c)
        near.add(owner[r * tiles.columns() + c]);
  }

  /** Returns 1 if plane \a a is in front of \a b over most of the region \a of, -1 if
   * it is behind, else 0. */
  static int
  sideOf(const TileMoments& tiles,
         const TileRegion& of,
         const InversePlane& a,
         const InversePlane& b)
  {
    double in_front = 0, all = 0;
    for (const std::uint32_t tile : of.tiles) {
      const Moments& sum = tiles[tile];
      const double apart =
          // inverse depth is larger for closer planes
          (a - b).dot(Eigen::Vector3d(sum.x, sum.y, sum.count));
      in_front += apart > 0 ? sum.count : 0;
      all += sum.count;
    }
    constexpr double most_of_it = 0.8;
    return in_front > most_of_it * all ? 1 : in_front < (1 - most_of_it) * all ? -1 : 0;
  }

  static Junction
  meet(const TileMoments& tiles, const TileRegion& a, const TileRegion& b)
  {
    const int at_a = sideOf(tiles, a, a.fit.plane, b.fit.plane);
    const int at_b = sideOf(tiles, b, b.fit.plane, a.fit.plane);
    return at_a == 0 || at_a != at_b ? Junction::None
           : at_a > 0                ? Junction::Inner
                                     : Junction::Outer;
  }

  std::vector<Near> near_;
  std::size_t planes_;
  std::vector<Junction> junctions_;
};

/** Assigns pixels to planes. */
class PixelLabels {
public:
  PixelLabels(const DepthView& view,
              const TileMoments& tiles,
              std::size_t edge,
              const std::vector<TileRegion>& regions,
              const PixelDeviation& deviation)
  : view_(view)
  , edge_(edge)
  , columns_(tiles.columns())
  , regions_(regions)
  , near_(tiles, regions)
  , bends_(tiles.size(), 0.0)
  {
    for (const TileRegion& region : regions) {
      const double sigma = deviation.on(region.fit.plane);
      bands_.push_back(deviations * sigma);
      for (const std::uint32_t tile : region.tiles)
        bends_[tile] =
            std::min(std::abs(residualOf(tiles[tile], region.fit.plane).mean),
                     deviations * sigma);
    }
  }

  std::vector<std::int32_t>
  choose() const
  {
    std::vector<std::int32_t> labels(view_.size(), no_plane);
    for (std::size_t row = 0, pixel = 0; row < view_.height(); ++row)
      for (std::size_t column = 0; column < view_.width(); ++column, ++pixel) {
        const std::size_t tile = row / edge_ * columns_ + column / edge_;
        const PlaneNeighbourhood::Near& near = near_[tile];
        if (near.size == 0 || !(view_.inverseDepth(pixel) > 0))
          continue;
        labels[pixel] =
            chooseOne(static_cast<double>(view_.inverseDepth(pixel)),
                      view_.ray(static_cast<double>(column), static_cast<double>(row)),
                      near,
                      bends_[tile]);
      }
    return labels;
  }

private:
  std::int32_t
  chooseOne(double inverse_depth,
            const Eigen::Vector3d& ray,
            const PlaneNeighbourhood::Near& near,
            double bend) const
  {
    std::int32_t best = no_plane;
    double best_place = 0;
    for (std::size_t k = 0; k < near.size; ++k) {
      const std::int32_t plane = near.planes[k];
      const double place = regions_[static_cast<std::size_t>(plane)].fit.plane.dot(ray);
      if (std::abs(place - inverse_depth) >
          bands_[static_cast<std::size_t>(plane)] + bend)
        continue;
      if (best != no_plane && !isBetter(plane, place, best, best_place, inverse_depth))
        continue;
      best = plane;
      best_place = place;
    }
    return best;
  }

  bool
  isBetter(std::int32_t plane,
           double place,
           std::int32_t best,
           double best_place,
           double inverse_depth) const
  {
    switch (near_.between(plane, best)) {
    case Junction::Inner:
      return place > best_place;
    case Junction::Outer:
      return place < best_place;
    default:
      return std::abs(place - inverse_depth) < std::abs(best_place - inverse_depth);
    }
  }

  static constexpr double deviations = 3.5;

  const DepthView& view_;
  std::size_t edge_;
  std::size_t columns_;
  const std::vector<TileRegion>& regions_;
  PlaneNeighbourhood near_;
  std::vector<double> bends_; ///< residuals of the tiles to their planes, 1/m
  std::vector<double> bands_; ///< maximum residual of a pixel of each plane, 1/m
};

/** Pixels get the label of at least six of their eight neighbours if there is one,
 * unless they are far from its plane. */
std::vector<std::int32_t>
withoutSpecks(const DepthView& view,
              const std::vector<TileRegion>& regions,
              const PixelDeviation& deviation,
              const std::vector<std::int32_t>& labels)
{
  const auto isNear = [&](std::size_t pixel, std::int32_t label) {
    if (label == no_plane)
      return true;
    constexpr double deviations = 7;
    const InversePlane& plane = regions[static_cast<std::size_t>(label)].fit.plane;
    const Eigen::Vector3d ray = view.ray(static_cast<double>(pixel % view.width()),
                                         static_cast<double>(pixel / view.width()));
    return std::abs(plane.dot(ray) - static_cast<double>(view.inverseDepth(pixel))) <
           deviations * deviation.on(plane);
  };
  std::vector<std::int32_t> result = labels;
  const std::size_t width = view.width();
  for (std::size_t row = 1; row + 1 < view.height(); ++row)
    for (std::size_t column = 1; column + 1 < width; ++column) {
      const std::size_t pixel = row * width + column;
      const std::int32_t own = labels[pixel];
      // most pixels are inside their plane
      if (own == labels[pixel - 1] && own == labels[pixel + 1] &&
          own == labels[pixel - width])
        continue;
      if (!(view.inverseDepth(pixel) > 0))
        continue;
      const std::array<std::int32_t, 8> others = {labels[pixel - width - 1],
                                                  labels[pixel - width],
                                                  labels[pixel - width + 1],
                                                  labels[pixel - 1],
                                                  labels[pixel + 1],
                                                  labels[pixel + width - 1],
                                                  labels[pixel + width],
                                                  labels[pixel + width + 1]};
      for (const std::int32_t other : others)
        if (other != own && isNear(pixel, other) &&
            std::count(others.begin(), others.end(), other) >= 6) {
          result[pixel] = other;
          break;
        }
    }
  return result;
}

} // namespace

std::vector<std::int32_t>
labelPixels(const DepthView& view,
            const TileMoments& tiles,
            std::size_t edge,
            const std::vector<TileRegion>& regions,
            const PixelDeviation& deviation)
{
  return withoutSpecks(view,
                       regions,
                       deviation,
                       PixelLabels(view, tiles, edge, regions, deviation).choose());
}

} // namespace pcl::acmap::depth
