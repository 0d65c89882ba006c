#include "entropy_grid.h"
#include "map_extent.h"
#include "planar_motion.h"
#include "wall_direction.h"

#include <pcl/mapping/map_entropy_kernel.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::acmap {
namespace {

/** A bin of the map and the points in it. */
struct FilledBin {
  std::int64_t x, z;
  int layer;
  std::uint64_t points;

  auto
  key() const
  {
    return std::tie(layer, x, z);
  }
};

/** Puts bins in order, and bins that are the same together. */
void
tidy(std::vector<FilledBin>& bins)
{
  std::sort(bins.begin(), bins.end(), [](const FilledBin& a, const FilledBin& b) {
    return a.key() < b.key();
  });
  std::size_t kept = 0;
  for (const FilledBin& bin : bins)
    if (kept && bins[kept - 1].key() == bin.key())
      bins[kept - 1].points += bin.points;
    else
      bins[kept++] = bin;
  bins.resize(kept);
}

int
layerOf(double direction, const PlanarMotion& motion, bool direction_aware)
{
  if (!direction_aware)
    return 0;
  if (std::isnan(direction))
    return wall_directions;
  const double turns = motion.direction(direction) / (2 * M_PI);
  const auto layer =
      static_cast<int>(std::floor((turns - std::floor(turns)) * wall_directions));
  return std::min(layer, wall_directions - 1);
}

/** The points of an observation in their bins. */
std::vector<FilledBin>
binsOf(const PosedPoints& observation,
       const MapEntropySettings& settings,
       MapExtent& extent,
       MapEntropyReport& report)
{
  const PlanarMotion motion(observation.pose);
  std::vector<FilledBin> bins;
  bins.reserve(observation.points.size());
  report.points += observation.points.size();
  for (std::size_t i = 0; i < observation.points.size(); ++i) {
    const Eigen::Vector3f point = observation.points[i];
    if (!point.allFinite()) {
      ++report.invalid_points;
      continue;
    }
    if (point.cwiseAbs().maxCoeff() > entropy_reach) {
      ++report.distant_points;
      continue;
    }
    const double direction =
        settings.direction_aware
            ? wallDirection(observation.points, observation.normals, i)
            : std::nan("");
    report.directed_points += !std::isnan(direction);
    const Eigen::Vector2d place = motion.place(point[0], point[2]);
    extent.add(place, 1);
    bins.push_back({static_cast<std::int64_t>(std::floor(place[0] / settings.bin_size)),
                    static_cast<std::int64_t>(std::floor(place[1] / settings.bin_size)),
                    layerOf(direction, motion, settings.direction_aware),
                    1});
  }
  tidy(bins);
  return bins;
}

} // namespace

MapEntropyTerms
exactMapEntropy(const std::vector<PosedPoints>& observations,
                const MapEntropySettings& settings,
                const Progress& progress,
                MapEntropyReport& report)
{
  requireSmoothing(settings);
  report.observations += observations.size();
  MapExtent extent;
  std::vector<BinRange> ranges(observations.size());
  std::vector<FilledBin> bins;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    progress.tell(0.9 * static_cast<double>(i) /
                      static_cast<double>(observations.size()),
                  "bins");
    const std::vector<FilledBin> more =
        binsOf(observations[i], settings, extent, report);
    for (const FilledBin& bin : more)
      ranges[i].add(bin.x, bin.z);
    bins.insert(bins.end(), more.begin(), more.end());
  }
  progress.tell(0.9, "entropy");
  if (!canHaveGrid(ranges, settings, report))
    return {};
  tidy(bins);
  BinRange all;
  for (const BinRange& range : ranges)
    all.add(range);
  EntropyGrid grid(all, settings);
  grid.allocate();
  grid.tell(report);
  double points = 0;
  for (const FilledBin& bin : bins) {
    grid.at(bin.layer, bin.x, bin.z) = static_cast<double>(bin.points);
    points += static_cast<double>(bin.points);
  }
  grid.smooth();
  MapEntropyTerms terms = grid.terms(points);
  terms.dimensions = extent.dimensions(settings.bin_size);
  remarkOnMap(terms, settings, report);
  return terms;
}

} // namespace pcl::acmap
