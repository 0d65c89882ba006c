#include "one_view.h"

#include <pcl/common/point_tests.h>
#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/simulation/simulated_observation.h>

#include <memory>

namespace pcl::acmap::bench {
namespace {

/** \brief Tolerance of the peers in metres, from PCL's tutorials for a Kinect. */
inline constexpr double view_tolerance = 0.02;

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

// Smoothing, angle and distance are those of PCL's organized_segmentation_demo. Its
// 10000 inliers, depth change of 0.02 and curvature of 0.001 lose planes: with 1000
// inliers it finds 83 of 120 in the simulated views. These settings find 91, the most
// of seven that were tried.
constexpr float max_depth_change = 0.05f;
constexpr double max_curvature = 0.01;
constexpr float smoothing = 20.0f; // px
constexpr unsigned min_inliers = 1000;
constexpr double max_angle = 3.0 * degree;

PointCloud<Normal>::Ptr
integralNormals(const OneView& view)
{
  using Estimation = IntegralImageNormalEstimation<PointXYZ, Normal>;
  Estimation estimation;
  estimation.setNormalEstimationMethod(Estimation::COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(max_depth_change);
  estimation.setNormalSmoothingSize(smoothing);
  estimation.setInputCloud(view.organized);
  const auto normals = std::make_shared<PointCloud<Normal>>();
  estimation.compute(*normals);
  return normals;
}

} // namespace

OneView
loadOneView(const std::string& name, const std::string& path)
{
  const auto cloud = std::make_shared<PointCloud<PointXYZ>>();
  fromPCLPointCloud2(loadPointCloud(path).cloud, *cloud);
  return makeOneView(name, cloud);
}

void
useAllPixels(SimulatedScene& scene)
{
  scene.sensor.points = static_cast<std::size_t>(scene.rig.width) *
                        static_cast<std::size_t>(scene.rig.height);
  scene.sensor.views_with_one_more = 0;
}

TrueView
makeTrueView(const SimulatedScene& scene, std::size_t view)
{
  const SimulatedObservation observation = observe(scene, view, 1);
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

FoundPlanes
ourPlanes(const OneView& view, DepthSensor sensor)
{
  MappedPlanes mapped;
  FoundPlanes found = timedPlanes([&] {
    FoundPlanes planes;
    PlaneMapping mapping;
    mapping.setNumberOfThreads(1);
    mapping.setComputeMesh(false);
    mapping.setDepthSensor(sensor);
    mapping.setInputCloud(view.organized);
    mapping.compute(mapped);
    for (const PlanePatch& patch : mapped.planes)
      planes.planes.push_back(patch.coefficients);
    return planes;
  });
  for (std::size_t i = 0; i < mapped.labels.size(); ++i)
    if (pcl::isFinite((*view.organized)[i]))
      found.labels.push_back(mapped.labels[i]);
  return found;
}

std::vector<Indices>
segmentOrganized(const OneView& view)
{
  OrganizedMultiPlaneSegmentation<PointXYZ, Normal, Label> segmentation;
  segmentation.setMinInliers(min_inliers);
  segmentation.setAngularThreshold(max_angle);
  segmentation.setDistanceThreshold(view_tolerance);
  segmentation.setMaximumCurvature(max_curvature);
  segmentation.setInputNormals(integralNormals(view));
  segmentation.setInputCloud(view.organized);
  std::vector<PlanarRegion<PointXYZ>, Eigen::aligned_allocator<PlanarRegion<PointXYZ>>>
      planes;
  std::vector<ModelCoefficients> coefficients;
  std::vector<PointIndices> inliers, of_labels, boundaries;
  auto labels = std::make_shared<PointCloud<Label>>();
  segmentation.segmentAndRefine(
      planes, coefficients, inliers, labels, of_labels, boundaries);
  std::vector<Indices> regions;
  for (const PointIndices& plane : inliers) {
    Indices region;
    for (const index_t pixel : plane.indices)
      if (const index_t i = view.finite_of_pixel[static_cast<std::size_t>(pixel)];
          i >= 0)
        region.push_back(i);
    if (!region.empty())
      regions.push_back(std::move(region));
  }
  return regions;
}

namespace {

/** \brief The same, with each plane fitted by least squares to its inliers. */
FoundPlanes
organizedPlanes(const OneView& view)
{
  return timedPlanes(
      [&] { return planesOfRegions(view.finite, segmentOrganized(view)); });
}

} // namespace

std::vector<OneViewFinder>
pictureFinders()
{
  return {{"acmap", [](const OneView& view) { return ourPlanes(view); }},
          {"acmap in space",
           [](const OneView& view) { return findAcmapPlanes(view.finite); }},
          {"PCL organized multi-plane", organizedPlanes}};
}

std::vector<OneViewFinder>
oneViewFinders()
{
  std::vector<OneViewFinder> all = pictureFinders();
  for (const NamedFinder& peer : peers())
    all.push_back(
        {peer.name,
         [find = peer.find](const OneView& view) { return find(view.finite); },
         peer.is_slow});
  return all;
}

FoundPlanes
findInView(const OneViewFinder& finder, const OneView& view)
{
  const auto find = [&](const PlaneInput&) { return finder.find(view); };
  return findPlanes({finder.name, find}, view.finite);
}

} // namespace pcl::acmap::bench
