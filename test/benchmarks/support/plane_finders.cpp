#include "plane_finders.h"

#include "bench.h"

#include <pcl/core/impl/moments.h>
#include <pcl/core/noise_scale.h>

#include <utility>

namespace pcl::acmap::bench {

SensorView
PlaneInput::sensors() const
{
  if (!views.empty())
    return {views.data(), sizeof(std::int32_t), origins};
  return origins.empty() ? SensorView() : SensorView(origins.front());
}

std::size_t
PlaneInput::leastSupport() const
{
  return largeCount(points->size());
}

double
toleranceFor(double sigma)
{
  constexpr double minimum = 0.002;
  return std::max(minimum, 3 * sigma);
}

PlaneInput
makePlaneInput(const PointCloud<PointXYZ>::Ptr& points,
               std::vector<Eigen::Vector3f> origins,
               std::vector<std::int32_t> views)
{
  PlaneInput input{points, std::move(origins), std::move(views)};
  const PointView view(points->points.data(), sizeof(PointXYZ), points->size());
  const NoiseScale scale = measureNoiseScale(view, input.sensors(), 1);
  input.sigma = scale.sigma;
  input.spacing = scale.spacing;
  input.tolerance = toleranceFor(scale.sigma);
  return input;
}

std::size_t
largeCount(std::size_t size)
{
  constexpr double share = 0.003;
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(size)));
}

std::vector<NamedFinder>
peers()
{
  constexpr std::size_t one_view = 400000, million = 1000000;
  std::vector<NamedFinder> all;
  const auto add = [&](const std::string& name,
                       std::vector<Indices> (*regions)(const PlaneInput&),
                       std::size_t max_points,
                       bool is_slow) {
    const auto find = [=](const PlaneInput& input) {
      return timedPlanes([&] { return planesOfRegions(input, regions(input)); });
    };
    all.push_back({name, find, false, max_points, is_slow});
  };
  add("PCL SAC, iterated", sacRegions, million, false);
  add("PCL region growing", pclRegions, one_view, true);
#ifdef ACMAP_HAVE_CGAL_REGIONS
  add("CGAL region growing", cgalRegions, million, true);
#endif
#ifdef ACMAP_HAVE_CGAL
  add("CGAL efficient RANSAC", ransacRegions, million, false);
#endif
  return all;
}

std::vector<NamedFinder>
allFinders()
{
  std::vector<NamedFinder> all = peers();
  all.insert(all.begin(), {"acmap", findAcmapPlanes, true});
  return all;
}

double
FoundPlanes::labelledPercent() const
{
  const auto labelled = std::count_if(
      labels.begin(), labels.end(), [](auto label) { return label >= 0; });
  return percent(static_cast<std::size_t>(labelled), labels.size());
}

FoundPlanes
findPlanes(const NamedFinder& finder, const PlaneInput& input)
{
  constexpr double fast = 1; // seconds
  constexpr int more_rounds = 2;
  FoundPlanes found = finder.find(input);
  if (found.seconds > fast)
    return found;
  std::vector<double> seconds{found.seconds};
  for (int round = 0; round < more_rounds; ++round)
    seconds.push_back(finder.find(input).seconds);
  found.seconds = median(seconds);
  return found;
}

namespace {

Eigen::Vector4d
planeThrough(const PointCloud<PointXYZ>& points, const Indices& region)
{
  const Eigen::Vector3d origin = points[region.front()].getVector3fMap().cast<double>();
  Moments moments;
  for (const index_t i : region) {
    const Eigen::Vector3d p = points[i].getVector3fMap().cast<double>() - origin;
    moments.addShifted(Moments{1}, p.x(), p.y(), p.z());
  }
  const PlaneFit fit = fitPlane(moments);
  Eigen::Vector4d plane;
  plane << fit.normal, -fit.normal.dot(origin + fit.mean);
  return plane;
}

} // namespace

FoundPlanes
planesOfRegions(const PlaneInput& input, const std::vector<Indices>& regions)
{
  FoundPlanes found;
  found.labels.assign(input.points->size(), -1);
  for (const Indices& region : regions) {
    for (const index_t i : region)
      found.labels[static_cast<std::size_t>(i)] =
          static_cast<std::int32_t>(found.planes.size());
    found.planes.push_back(planeThrough(*input.points, region));
  }
  return found;
}

} // namespace pcl::acmap::bench
