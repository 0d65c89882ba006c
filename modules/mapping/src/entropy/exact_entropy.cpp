#include "entropy_grid.h"
#include "map_extent.h"
#include "planar_motion.h"
#include "point_weights.h"
#include "wall_direction.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {
namespace {

/** Positions of the points under a pose, in bins of the map. */
class PosedBins {
public:
  PosedBins(const PosedPoints& observation, const MapEntropySettings& settings)
  : observation_(observation)
  , settings_(settings)
  , motion_(observation.pose)
  {}

  /** Calls visit (index, x, z) for the points that are finite and not distant. */
  template <typename Visit>
  void
  forEachPoint(const Visit& visit) const
  {
    for (std::size_t i = 0; i < observation_.points.size(); ++i) {
      const Eigen::Vector3f point = observation_.points[i];
      if (!(point.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= entropy_reach))
        continue;
      const Eigen::Vector2d place = motion_.place(point[0], point[2]);
      visit(i, place[0] / settings_.bin_size, place[1] / settings_.bin_size);
    }
  }

  int
  layerOf(std::size_t point) const
  {
    if (!settings_.direction_aware)
      return 0;
    const WallDirection normal =
        wallDirection(observation_.points, observation_.normals, point);
    if (!normal.isDirected())
      return wall_directions;
    const double turns = motion_.direction(normal.angle()) / (2 * M_PI);
    const auto layer =
        static_cast<int>(std::floor((turns - std::floor(turns)) * wall_directions));
    return std::min(layer, wall_directions - 1);
  }

private:
  const PosedPoints& observation_;
  const MapEntropySettings& settings_;
  PlanarMotion motion_;
};

void
count(const PosedPoints& observation,
      const MapEntropySettings& settings,
      MapEntropyReport& report)
{
  report.points += observation.points.size();
  for (std::size_t i = 0; i < observation.points.size(); ++i) {
    const Eigen::Vector3f point = observation.points[i];
    if (!point.allFinite())
      ++report.invalid_points;
    else if (point.cwiseAbs().maxCoeff() > entropy_reach)
      ++report.distant_points;
    else if (settings.direction_aware)
      report.directed_points +=
          wallDirection(observation.points, observation.normals, i).isDirected();
  }
}

/** Range of the bins of points that have a weight. The positions of these points in
 * bins are added to \a extent. */
BinRange
rangeOf(const PosedBins& bins, const PointWeights& weights, MapExtent& extent)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Array2d least(infinity, infinity), most = -least;
  bins.forEachPoint([&](std::size_t i, double x, double z) {
    const Eigen::Array2d place(x, z);
    if (weights[i] == 0)
      return;
    extent.add(place, static_cast<double>(weights[i]));
    least = least.min(place);
    most = most.max(place);
  });
  BinRange range;
  if (least[0] > most[0])
    return range;
  range.add(binOf(least[0]), binOf(least[1]));
  range.add(binOf(most[0]), binOf(most[1]));
  return range;
}

/** Adds the points to the bins; the sums are of integers, so they do not depend on the
 * order. */
void
fill(const PosedBins& bins,
     const PointWeights& weights,
     const EntropyGrid& grid,
     std::vector<double>& sums)
{
  const BinArray& array = grid.bins();
  bins.forEachPoint([&](std::size_t i, double x, double z) {
    if (weights[i] == 0)
      return;
    const std::int64_t at = bins.layerOf(i) * array.layer +
                            (binOf(x) - grid.firstX()) * array.row + binOf(z) -
                            grid.firstZ();
    sums[static_cast<std::size_t>(at)] += static_cast<double>(weights[i]);
    array.marks[at / BinArray::block] = 1;
  });
}

} // namespace

MapEntropyTerms
exactMapEntropy(const std::vector<PosedPoints>& observations,
                const MapEntropySettings& settings,
                const Progress& progress,
                MapEntropyReport& report)
{
  requireSmoothing(settings);
  const std::size_t size = observations.size();
  float largest = 0;
  for (const PosedPoints& observation : observations) {
    requirePlanarPose(observation.pose);
    largest = std::max(largest,
                       largestWeight(observation.weights, observation.points.size()));
  }
  report.observations += size;
  const std::size_t counted_before = report.points - report.invalid_points;
  MapExtent extent;
  std::vector<BinRange> ranges;
  BinRange all;
  for (std::size_t i = 0; i < size; ++i) {
    progress.tell(0.4 * static_cast<double>(i) / static_cast<double>(size), "extent");
    count(observations[i], settings, report);
    ranges.push_back(rangeOf(
        {observations[i], settings}, {observations[i].weights, largest}, extent));
    all.add(ranges[i]);
  }
  if (!canHaveGrid(ranges, extent.weight(), settings, report))
    return {};

  EntropyGrid grid(settings);
  grid.begin(all);
  grid.tell(report);
  std::vector<double> sums(
      static_cast<std::size_t>(layersOf(settings) * grid.bins().layer), 0);
  for (std::size_t i = 0; i < size; ++i) {
    progress.tell(0.4 + 0.5 * static_cast<double>(i) / static_cast<double>(size),
                  "bins");
    fill({observations[i], settings}, {observations[i].weights, largest}, grid, sums);
  }
  const double unit = unitFor(extent.weight());
  std::transform(sums.begin(), sums.end(), grid.bins().bins, [=](double sum) {
    return static_cast<float>(sum * unit);
  });
  progress.tell(0.9, "entropy");
  MapEntropyTerms terms = grid.finish(extent.weight() * unit, false);
  terms.points = report.points - report.invalid_points - counted_before;
  terms.dimensions = extent.dimensions(1);
  remarkOnMap(terms, settings, report);
  return terms;
}

} // namespace pcl::acmap
