#include "simulated_clouds.h"

#include <pcl/core/random.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <sstream>

namespace pcl::acmap::bench {

namespace {

constexpr std::uint64_t noise_seed = 1;

SimulatedCloud
makeEmptyPart(const SimulatedCloud& cloud, const std::string& name)
{
  SimulatedCloud part;
  part.name = name;
  part.T_scene_cloud = cloud.T_scene_cloud;
  part.merged.trajectory = cloud.merged.trajectory;
  part.merged.planes = cloud.merged.planes;
  return part;
}

void
appendPoint(const MergedObservations& all, std::size_t i, MergedObservations& part)
{
  part.points.push_back(all.points[i]);
  part.rgb.push_back(all.rgb[i]);
  part.view.push_back(all.view[i]);
  part.label.push_back(all.label[i]);
}

} // namespace

PointView
SimulatedCloud::points() const
{
  return {merged.points.data(), sizeof(Eigen::Vector3f), merged.points.size()};
}

std::vector<Eigen::Vector3f>
SimulatedCloud::sensorOrigins() const
{
  std::vector<Eigen::Vector3f> origins;
  for (const Eigen::Isometry3d& pose : merged.trajectory.poses)
    origins.emplace_back(pose.translation().cast<float>());
  return origins;
}

SensorView
SimulatedCloud::sensors() const
{
  return {merged.view.data(), sizeof(std::int32_t), sensorOrigins()};
}

ColorView
SimulatedCloud::colors() const
{
  return {merged.rgb.data(), sizeof(std::uint32_t)};
}

SimulatedCloud
makeViewCloud(const SimulatedScene& scene, std::size_t view)
{
  SimulatedCloud cloud;
  cloud.name = "view " + std::to_string(view);
  cloud.T_scene_cloud = scene.views[view];
  cloud.merged.trajectory = {{0.0}, {Eigen::Isometry3d::Identity()}};
  for (const TruthPlane& plane : scene.geometry.planes())
    cloud.merged.planes.push_back(transformPlane(plane, scene.views[view].inverse()));
  appendObservation(observe(scene, view, noise_seed), 0, cloud.merged);
  return cloud;
}

SimulatedCloud
makeSceneCloud(const SimulatedScene& scene)
{
  SimulatedCloud cloud;
  cloud.name = scene.name + ", all views";
  cloud.T_scene_cloud = scene.views.front();
  cloud.merged = mergeObservations(scene, 0, noise_seed);
  return cloud;
}

SimulatedCloud
makeRandomPart(const SimulatedCloud& cloud, std::size_t size, std::uint64_t seed)
{
  SimulatedCloud part = makeEmptyPart(cloud, "random " + std::to_string(size));
  Random random(seed);
  for (std::size_t i = 0; i < cloud.size() && part.size() < size; ++i) {
    const auto left = static_cast<double>(cloud.size() - i);
    if (random.uniform() * left >= static_cast<double>(size - part.size()))
      continue;
    appendPoint(cloud.merged, i, part.merged);
  }
  return part;
}

SimulatedCloud
makeCrop(const SimulatedCloud& cloud, std::size_t size)
{
  std::vector<double> along;
  along.reserve(cloud.size());
  for (const Eigen::Vector3f& point : cloud.merged.points)
    along.push_back((cloud.T_scene_cloud * point.cast<double>()).z());
  std::vector<double> sorted = along;
  const std::size_t last = std::min(size, sorted.size()) - 1;
  std::nth_element(
      sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(last), sorted.end());
  SimulatedCloud part = makeEmptyPart(cloud, "crop " + std::to_string(size));
  for (std::size_t i = 0; i < cloud.size() && part.size() < size; ++i)
    if (along[i] <= sorted[last])
      appendPoint(cloud.merged, i, part.merged);
  return part;
}

Consolidation
consolidate(const SimulatedCloud& cloud, double voxel, ConsolidationReport& report)
{
  ConsolidationSettings settings;
  settings.voxel_size = voxel;
  settings.threads = 1;
  return consolidatePoints(
      cloud.points(), cloud.sensors(), cloud.colors(), settings, Progress(), report);
}

std::string
voxelName(double voxel)
{
  if (!(voxel > 0))
    return "automatic";
  std::ostringstream name;
  name << 100 * voxel << " cm";
  return name.str();
}

SceneData::SceneData(const std::string& standard_scene)
: scene_(standardScene(standard_scene))
{}

const SimulatedCloud&
SceneData::whole()
{
  if (!whole_)
    whole_ = std::make_unique<SimulatedCloud>(makeSceneCloud(scene_));
  return *whole_;
}

const SceneTruth&
SceneData::wholeTruth()
{
  constexpr int finer = 2;
  if (!truth_) {
    truth_ = std::make_unique<SceneTruth>(scene_);
    for (std::size_t view = 0; view < scene_.views.size(); ++view)
      truth_->see(scene_, view, finer);
  }
  return *truth_;
}

SceneTruth
SceneData::truthOfView(std::size_t view) const
{
  constexpr int finer = 4;
  SceneTruth truth(scene_);
  truth.see(scene_, view, finer);
  return truth;
}

SceneData&
corridor()
{
  static SceneData data("corridor");
  return data;
}

PointCloud<PointXYZ>::Ptr
plainPoints(const SimulatedCloud& cloud)
{
  const auto result = std::make_shared<PointCloud<PointXYZ>>();
  result->reserve(cloud.size());
  for (const Eigen::Vector3f& point : cloud.merged.points)
    result->emplace_back(point.x(), point.y(), point.z());
  return result;
}

PointCloud<PointXYZRGBNormalView>::Ptr
mapPoints(const SimulatedCloud& cloud)
{
  const auto result = std::make_shared<PointCloud<PointXYZRGBNormalView>>();
  result->reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    PointXYZRGBNormalView point;
    point.getVector3fMap() = cloud.merged.points[i];
    point.rgba = cloud.merged.rgb[i];
    point.view = cloud.merged.view[i];
    result->push_back(point);
  }
  return result;
}

} // namespace pcl::acmap::bench
