#include "depth/tile_regions.h"

#include <pcl/core/impl/arguments.h>
#include <pcl/core/impl/depth_planes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pcl::acmap::depth {

namespace {

constexpr std::int32_t no_plane = -1;

/** Type of the edge between two planes, as seen from the sensor. */
enum class Junction : std::int8_t {
  None,
  Inner, ///< concave: the front plane is visible, e.g. wall and floor
  Outer  ///< convex: the rear plane is visible, e.g. two faces of a box
};

/** Planes near each tile, and types of the edges between planes. */
class PlaneNeighbourhood {
public:
  static constexpr std::size_t maximum = 6;

  struct Near {
    std::array<std::int32_t, maximum> planes;
    std::size_t size = 0;

    void
    add(std::int32_t plane)
    {
      if (plane == no_plane || size == maximum ||
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
              const std::vector<TileRegion>& regions,
              const PixelDeviation& deviation)
  : view_(view)
  , edge_(tiles.edge())
  , columns_(tiles.columns())
  , regions_(regions)
  , deviation_(deviation)
  , near_(tiles, regions)
  , bends_(tiles.size(), 0.0)
  {
    for (const TileRegion& region : regions) {
      const double sigma = deviation.on(region);
      bands_.push_back(deviations * sigma);
      for (const std::uint32_t tile : region.tiles)
        bends_[tile] =
            std::min(std::abs(residualOf(tiles[tile], region.fit.plane).mean),
                     deviations * sigma);
    }
  }

  PointLabels
  choose() const
  {
    PointLabels labels(view_.size(), no_plane);
    for (std::size_t row = 0, pixel = 0; row < view_.height(); ++row)
      for (std::size_t column = 0; column < view_.width(); ++column, ++pixel) {
        const std::size_t tile = row / edge_ * columns_ + column / edge_;
        const PlaneNeighbourhood::Near& near = near_[tile];
        if (near.size == 0 || !(view_.inverseDepth(pixel) > 0))
          continue;
        labels[pixel] = chooseOne(static_cast<double>(view_.inverseDepth(pixel)),
                                  view_.rayOf(column, row),
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
      if (std::abs(place - inverse_depth) > bandOf(plane, place) + bend)
        continue;
      if (best != no_plane && !isBetter(plane, place, best, best_place, inverse_depth))
        continue;
      best = plane;
      best_place = place;
    }
    return best;
  }

  /** Maximum residual of a pixel of a plane, 1/m.
   * \param[in] place inverse depth of the plane at the pixel */
  double
  bandOf(std::int32_t plane, double place) const
  {
    const auto region = static_cast<std::size_t>(plane);
    return deviation_.isIndependent()
               ? deviations * deviation_.on(regions_[region].fit.plane, place)
               : bands_[region];
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
  const PixelDeviation& deviation_;
  PlaneNeighbourhood near_;
  std::vector<double> bends_; ///< residuals of the tiles to their planes, 1/m
  std::vector<double> bands_; ///< of each plane, where they are uniform, 1/m
};

/** Pixels get the label of at least six of their eight neighbours if there is one,
 * unless they are far from its plane. */
PointLabels
withoutSpecks(const DepthView& view,
              const std::vector<TileRegion>& regions,
              const PixelDeviation& deviation,
              const PointLabels& labels)
{
  const auto isNear = [&](std::size_t pixel, std::int32_t label) {
    if (label == no_plane)
      return true;
    constexpr double deviations = 7;
    const InversePlane& plane = regions[static_cast<std::size_t>(label)].fit.plane;
    const Eigen::Vector3d ray = view.rayOf(pixel % view.width(), pixel / view.width());
    const double place = plane.dot(ray);
    return std::abs(place - static_cast<double>(view.inverseDepth(pixel))) <
           deviations * deviation.on(plane, place);
  };
  PointLabels result = labels;
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

/** Assigns each pixel to a region.
 * \return for each pixel the index of its region, or no_plane */
PointLabels
labelPixels(const DepthView& view,
            const TileMoments& tiles,
            const std::vector<TileRegion>& regions,
            const PixelDeviation& deviation)
{
  return withoutSpecks(
      view, regions, deviation, PixelLabels(view, tiles, regions, deviation).choose());
}

/** Sums over the pixels of a plane. */
struct PlaneSum {
  Moments moments;
  double area = 0; ///< square metres
};

std::vector<PlaneSum>
sumPixels(const DepthView& view,
          const PointLabels& labels,
          const std::vector<DepthPlane>& planes)
{
  std::vector<PlaneSum> sums(planes.size());
  std::vector<double> scales;
  for (const DepthPlane& plane : planes)
    scales.push_back(plane.inverse.norm() /
                     std::abs(view.focal().x() * view.focal().y()));
  for (std::size_t row = 0, pixel = 0; row < view.height(); ++row)
    for (std::size_t column = 0; column < view.width(); ++column, ++pixel) {
      if (labels[pixel] == no_plane)
        continue;
      const auto plane = static_cast<std::size_t>(labels[pixel]);
      const Eigen::Vector3d ray = view.rayOf(column, row);
      const double inverse_depth = static_cast<double>(view.inverseDepth(pixel));
      sums[plane].moments += momentsOf({ray.x(), ray.y(), inverse_depth});
      // dA = z^3 |(a, b, c)| dx dy
      sums[plane].area +=
          scales[plane] / (inverse_depth * inverse_depth * inverse_depth);
    }
  return sums;
}

/** Area in square metres that the pixels of a region cover on its plane. */
double
areaOf(const DepthView& view, const TileRegion& region)
{
  const Moments& m = region.moments;
  const Eigen::Vector3d middle(m.x / m.count, m.y / m.count, 1);
  const double inverse_depth = std::max(region.fit.plane.dot(middle), 1e-9);
  return m.count * region.fit.plane.norm() /
         (std::abs(view.focal().x() * view.focal().y()) * inverse_depth *
          inverse_depth * inverse_depth);
}

double
leastArea(const DepthView& view, const DepthPlaneSettings& settings)
{
  if (settings.min_area > 0)
    return settings.min_area;
  double squares = 0;
  for (std::size_t pixel = 0; pixel < view.size(); ++pixel)
    if (view.inverseDepth(pixel) > 0)
      squares += 1 / (static_cast<double>(view.inverseDepth(pixel)) *
                      static_cast<double>(view.inverseDepth(pixel)));
  constexpr double of_buildings = 0.1, share = 0.003;
  return std::min(of_buildings,
                  share * squares / std::abs(view.focal().x() * view.focal().y()));
}

/** Keeps regions that are large enough, whose tilt is certain and whose residuals are
 * small.
 * \return the number of removed regions */
std::size_t
dropSmall(const DepthView& view,
          double min_area,
          const PixelDeviation& deviation,
          std::vector<TileRegion>& regions)
{
  constexpr double max_tilt = 0.15; // radians
  constexpr double max_rms = 2.2;   // standard deviations
  const std::size_t before = regions.size();
  regions.erase(std::remove_if(regions.begin(),
                               regions.end(),
                               [&](const TileRegion& region) {
                                 return areaOf(view, region) < min_area ||
                                        tiltOf(region, deviation) > max_tilt ||
                                        region.fit.rms > max_rms * deviation.on(region);
                               }),
                regions.end());
  return before - regions.size();
}

void
fitToPixels(const DepthView& view, DepthPlanes& result)
{
  const std::vector<PlaneSum> sums = sumPixels(view, result.labels, result.planes);
  for (std::size_t p = 0; p < sums.size(); ++p) {
    DepthPlane& plane = result.planes[p];
    plane.area = sums[p].area;
    plane.pixels = static_cast<std::size_t>(sums[p].moments.count);
    if (plane.pixels == 0)
      continue;
    const InverseFit fit = fitInverse(sums[p].moments);
    plane.inverse = fit.plane;
    plane.rms = fit.rms;
  }
}

/** Sorts by area and removes planes below the minimum area.
 * \return the number of removed planes */
std::size_t
sortPlanes(double min_area, DepthPlanes& result)
{
  std::vector<std::size_t> order(result.planes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return result.planes[a].area > result.planes[b].area;
  });
  std::vector<std::int32_t> numbers(order.size(), no_plane);
  std::vector<DepthPlane> sorted;
  for (const std::size_t p : order)
    if (result.planes[p].area >= min_area) {
      numbers[p] = static_cast<std::int32_t>(sorted.size());
      sorted.push_back(result.planes[p]);
    }
  for (std::int32_t& label : result.labels)
    label = label == no_plane ? no_plane : numbers[static_cast<std::size_t>(label)];
  const std::size_t dropped = result.planes.size() - sorted.size();
  result.planes = std::move(sorted);
  return dropped;
}

} // namespace

} // namespace pcl::acmap::depth

namespace pcl::acmap {

DepthPlanes
findDepthPlanes(const DepthView& view,
                const DepthPlaneSettings& settings,
                const Progress& progress)
{
  using namespace depth;
  const PixelDeviation deviation(view, settings.noise);
  const double min_area = leastArea(view, settings);
  progress.tell(0.0, "tiles");
  // the mean of few pixels is sure only where they do not share their noise
  constexpr std::size_t edge = 4, edge_of_shared_noise = 8;
  const TileMoments tiles(view,
                          deviation.isIndependent() ? edge : edge_of_shared_noise);
  progress.tell(0.2, "growing");
  DepthPlanes result;
  std::vector<TileRegion> regions = growTileRegions(tiles, deviation);
  result.merged = mergeTileRegions(tiles, deviation, regions);
  result.curved = dropCurvedRegions(tiles, deviation, regions);
  result.small = dropSmall(view, min_area, deviation, regions);
  progress.tell(0.5, "labels");
  result.labels = labelPixels(view, tiles, regions, deviation);
  for (const TileRegion& region : regions) {
    result.planes.emplace_back();
    result.planes.back().inverse = region.fit.plane;
  }
  fitToPixels(view, result);
  result.small += sortPlanes(min_area, result);
  progress.tell(1.0, "done");
  return result;
}

DepthPlanes
depthPlanesOf(const std::vector<PlanePatch>& patches, const PointLabels& labels)
{
  DepthPlanes known;
  for (const PlanePatch& patch : patches) {
    constexpr double nearest = 1e-6; // metres
    const double distance = patch.coefficients[3];
    if (!patch.coefficients.allFinite() || std::abs(distance) < nearest)
      refuseArgument("distance of a plane from the sensor",
                     distance,
                     "finite and not 0: a sensor sees no plane that it lies on");
    known.planes.emplace_back();
    known.planes.back().inverse = -patch.coefficients.head<3>() / distance;
  }
  for (const std::int32_t label : labels)
    if (label < -1 || label >= static_cast<std::int32_t>(patches.size()))
      refuseArgument("label of a pixel",
                     label,
                     "-1 or one of the " + std::to_string(patches.size()) + " planes");
  known.labels = labels;
  return known;
}

} // namespace pcl::acmap
