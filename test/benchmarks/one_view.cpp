#include "one_view.h"

#include "statistics.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/simulation/simulated_observation.h>

#include <memory>
#include <set>

namespace pcl::acmap::bench {
namespace {

constexpr std::uint64_t seed = 1;

} // namespace

OneView
makeOneView(const std::string& name, const PointCloud<PointXYZ>::Ptr& organized)
{
  OneView view{name, organized, {}, Indices(organized->size(), -1)};
  const auto finite = std::make_shared<PointCloud<PointXYZ>>();
  for (std::size_t i = 0; i < organized->size(); ++i)
    if ((*organized)[i].getVector3fMap().allFinite()) {
      view.finite_of_pixel[i] = static_cast<index_t>(finite->size());
      finite->push_back((*organized)[i]);
    }
  view.finite = makePlaneInput(finite, {Eigen::Vector3f::Zero()}, {});
  view.finite.tolerance = view_tolerance;
  return view;
}

OneView
loadOneView(const std::string& name, const std::string& path)
{
  const auto cloud = std::make_shared<PointCloud<PointXYZ>>();
  fromPCLPointCloud2(loadPointCloud(path).cloud, *cloud);
  return makeOneView(name, cloud);
}

TrueView
makeTrueView(const SimulatedScene& scene, std::size_t view)
{
  const SimulatedObservation observation = observe(scene, view, seed);
  const auto organized = std::make_shared<PointCloud<PointXYZ>>();
  fromPCLPointCloud2(cloudOf(observation), *organized);
  TrueView made;
  made.view = makeOneView(scene.name + " " + std::to_string(view), organized);
  for (const TruthPlane& plane : scene.geometry.planes())
    made.truth.planes.push_back(transformPlane(plane, scene.views[view].inverse()));
  for (std::size_t i = 0; i < observation.pixels.size(); ++i)
    if (made.view.finite_of_pixel[i] >= 0)
      made.truth.labels.push_back(
          static_cast<std::int32_t>(observation.pixels[i].label) - 1);
  return made;
}

double
inverseDepthStep(const OneView& view)
{
  std::set<float> depths;
  for (const PointXYZ& point : *view.finite.points)
    depths.insert(point.z);
  std::vector<double> steps;
  double before = 0;
  for (const float depth : depths) {
    if (before > 0)
      steps.push_back(1 / before - 1 / static_cast<double>(depth));
    before = depth;
  }
  return median(steps);
}

} // namespace pcl::acmap::bench
