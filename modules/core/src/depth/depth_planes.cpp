#include "depth/pixel_labels.h"

#include <pcl/core/arguments.h>
#include <pcl/core/depth_planes.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap {

namespace depth {
namespace {

constexpr std::size_t tile_edge = 8;

/** Sums over the pixels of a plane. */
struct PlaneSum {
  Moments moments;
  double area = 0; ///< square metres
};

std::vector<PlaneSum>
sumPixels(const DepthView& view,
          const std::vector<std::int32_t>& labels,
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
      const Eigen::Vector3d ray =
          view.ray(static_cast<double>(column), static_cast<double>(row));
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
                                        region.fit.rms >
                                            max_rms * deviation.on(region.fit.plane);
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
} // namespace depth

DepthPlanes
findDepthPlanes(const DepthView& view,
                const DepthPlaneSettings& settings,
                const Progress& progress)
{
  using namespace depth;
  const PixelDeviation deviation(view, settings.noise.sigma());
  const double min_area = leastArea(view, settings);
  progress.tell(0.0, "tiles");
  const TileMoments tiles(view, tile_edge);
  progress.tell(0.2, "growing");
  DepthPlanes result;
  std::vector<TileRegion> regions = growTileRegions(tiles, deviation);
  result.merged = mergeTileRegions(tiles, deviation, regions);
  result.curved = dropCurvedRegions(tiles, deviation, regions);
  result.small = dropSmall(view, min_area, deviation, regions);
  progress.tell(0.5, "labels");
  result.labels = labelPixels(view, tiles, tile_edge, regions, deviation);
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
depthPlanesOf(const std::vector<PlanePatch>& patches,
              const std::vector<std::int32_t>& labels)
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
