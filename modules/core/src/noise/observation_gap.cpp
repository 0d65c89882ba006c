#include "noise/point_sample.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/impl/observation_gap.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/voxel_lattice.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace pcl::acmap {

namespace {

/** A place at which observations are compared, and the points around it. */
struct ComparedPlace {
  Eigen::Vector3f middle;
  std::int32_t observation; ///< of the middle
  std::vector<std::pair<Eigen::Vector3f, std::int32_t>> around;
};

/** Compared places by the voxels that they reach into. */
class PlacesByVoxel {
public:
  PlacesByVoxel(const PointView& points, double radius)
  : lattice_(points, radius)
  {}

  void
  add(const Eigen::Vector3f& middle, std::size_t number)
  {
    VoxelHit hit;
    if (!lattice_.locate(middle, hit))
      return;
    for (std::int32_t dx = -1; dx <= 1; ++dx)
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dz = -1; dz <= 1; ++dz)
          numbers_[voxelKey({hit.place[0] + dx, hit.place[1] + dy, hit.place[2] + dz})]
              .push_back(number);
  }

  const std::vector<std::size_t>&
  near(const Eigen::Vector3f& point) const
  {
    static const std::vector<std::size_t> none;
    VoxelHit hit;
    if (!lattice_.locate(point, hit))
      return none;
    const auto found = numbers_.find(voxelKey(hit.place));
    return found == numbers_.end() ? none : found->second;
  }

private:
  VoxelLattice lattice_;
  std::unordered_map<VoxelKey, std::vector<std::size_t>> numbers_;
};

/** Root mean square distance of the points of other observations from the plane of one;
 * negative if that one shows no plane, or the others too few points. */
double
gapAt(const ComparedPlace& place, double radius)
{
  constexpr double enough = 8, flat = 0.15; // points; of the radius
  Moments own;
  for (const auto& [point, observation] : place.around)
    if (observation == place.observation)
      own += momentsOf((point - place.middle).cast<double>());
  if (own.count < enough)
    return -1;
  const PlaneFit plane = fitPlane(own);
  if (!plane.isPlanar() || plane.thickness() > flat * radius)
    return -1;
  double squares = 0, count = 0;
  for (const auto& [point, observation] : place.around) {
    if (observation == place.observation)
      continue;
    const Eigen::Vector3d from = (point - place.middle).cast<double>();
    squares += std::pow(plane.normal.dot(from - plane.mean), 2);
    count += 1;
  }
  return count < enough ? -1 : std::sqrt(squares / count);
}

/** Some 2,000 points as places, which are still without points around them. */
std::vector<ComparedPlace>
placesOf(const PointView& points, const SensorView& sensors)
{
  constexpr std::size_t wanted = 1 << 11;
  const PointSample sample(points.size(), wanted);
  std::vector<ComparedPlace> places;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite() && sensors.observation(i) >= 0 && sample.holds(points[i]))
      places.push_back({points[i], sensors.observation(i), {}});
  return places;
}

/** Adds the chosen points to the places around which they are. */
void
addPoints(const PointView& points,
          const SensorView& sensors,
          const PointSample& sample,
          double radius,
          std::vector<ComparedPlace>& places)
{
  PlacesByVoxel by_voxel(points, radius);
  for (std::size_t place = 0; place < places.size(); ++place)
    by_voxel.add(places[place].middle, place);
  using Found = std::vector<std::pair<std::size_t, std::size_t>>; // place, point
  const auto findNear = [&](std::size_t begin, std::size_t end) {
    Found found;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f point = points[i];
      if (!point.allFinite() || sensors.observation(i) < 0 || !sample.holds(point))
        continue;
      for (const std::size_t place : by_voxel.near(point))
        if ((point - places[place].middle).norm() < static_cast<float>(radius))
          found.emplace_back(place, i);
    }
    return found;
  };
  const auto join = [](Found& all, const Found& next) {
    all.insert(all.end(), next.begin(), next.end());
  };
  for (const auto& [place, i] :
       parallelReduceChunks(points.size(), Found(), findNear, join))
    places[place].around.emplace_back(points[i], sensors.observation(i));
}

} // namespace

ObservationGap
measureObservationGap(const PointView& points,
                      const SensorView& sensors,
                      double spacing,
                      unsigned threads)
{
  constexpr std::size_t max_points = 1 << 22;
  constexpr double spacings = 10;
  if (!(spacing > 0) || !sensors.isKnown() || sensors.single())
    return {};
  return withThreads(threads, [&] {
    const double thinning =
        std::max(1.0, static_cast<double>(points.size()) / max_points);
    ObservationGap result;
    result.radius = spacings * spacing * std::sqrt(thinning);
    std::vector<ComparedPlace> places = placesOf(points, sensors);
    addPoints(
        points, sensors, PointSample(points.size(), max_points), result.radius, places);
    std::vector<double> gaps;
    for (const ComparedPlace& place : places)
      if (const double gap = gapAt(place, result.radius); gap >= 0)
        gaps.push_back(gap);
    result.places = gaps.size();
    if (!gaps.empty())
      result.gap = medianOf(gaps);
    return result;
  });
}

} // namespace pcl::acmap
