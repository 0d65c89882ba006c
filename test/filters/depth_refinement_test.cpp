#include "depth_room.h"

#include <pcl/core/exceptions.h>
#include <pcl/filters/depth_refinement.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::acmap::test {
namespace {

using Cloud = PointCloud<PointNormal>;

Cloud::Ptr
cloudOf(const std::vector<Eigen::Vector3f>& points)
{
  Cloud::Ptr cloud(new Cloud);
  for (const Eigen::Vector3f& place : points) {
    PointNormal point;
    point.getVector3fMap() = place;
    point.curvature = 7;
    cloud->push_back(point);
  }
  cloud->width = DepthRoom::width;
  cloud->height = DepthRoom::height;
  return cloud;
}

Cloud
refined(const Cloud::ConstPtr& cloud, DepthRefinementReport* report = nullptr)
{
  DepthRefinement<PointNormal> refinement;
  refinement.setInputCloud(cloud);
  Cloud result;
  refinement.filter(result);
  if (report)
    *report = refinement.getReport();
  return result;
}

/** Root mean square of the depth errors. */
double
errorOf(const std::vector<double>& truth, const Cloud& cloud)
{
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double off = static_cast<double>(cloud[i].z) - truth[i];
    if (!std::isfinite(off))
      continue;
    squares += off * off;
    ++count;
  }
  return std::sqrt(squares / count);
}

TEST(DepthRefinement, takesTheStepsOut)
{
  const DepthRoom room({});
  const Cloud::Ptr cloud = cloudOf(room.points);
  DepthRefinementReport report;
  const Cloud result = refined(cloud, &report);
  ASSERT_EQ(result.width, cloud->width);
  ASSERT_EQ(result.height, cloud->height);
  EXPECT_LT(errorOf(room.true_depths, result), 0.4 * errorOf(room.true_depths, *cloud));
  EXPECT_EQ(report.planes, room.planes.size());
  EXPECT_GT(report.on_planes, 0.95 * static_cast<double>(report.points));
  std::size_t right = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Eigen::Vector3f normal = result[i].getNormalVector3fMap();
    if (std::isnan(result[i].x))
      continue;
    // positions only change along the ray, and normals point to the sensor
    EXPECT_LT(
        (result[i].getVector3fMap() / result[i].z - room.points[i] / room.points[i].z())
            .norm(),
        1e-4);
    ASSERT_LT(normal.dot(result[i].getVector3fMap()), 0);
    right += -normal.cast<double>().dot(
                 room.planes[static_cast<std::size_t>(room.truth[i])].normal) >
                     std::cos(0.05)
                 ? 1
                 : 0;
  }
  EXPECT_GT(right, 0.95 * static_cast<double>(result.size()));
}

TEST(DepthRefinement, smoothsWhatIsCurved)
{
  const std::vector<Eigen::Vector3f> points = depthOfCylinder({}, 0.4, 2.0);
  DepthRoom::Camera exact;
  exact.step = exact.independent = exact.correlated = 0;
  std::vector<double> truth;
  for (const Eigen::Vector3f& point : depthOfCylinder(exact, 0.4, 2.0))
    truth.push_back(static_cast<double>(point.z()));
  const Cloud::Ptr cloud = cloudOf(points);
  DepthRefinementReport report;
  const Cloud result = refined(cloud, &report);
  EXPECT_LT(errorOf(truth, result), 0.7 * errorOf(truth, *cloud));
  EXPECT_GT(report.smoothed,
            0.8 * static_cast<double>(report.points - report.invalid_points));
}

TEST(DepthRefinement, withdrawsWhatHangsBetweenSurfaces)
{
  DepthRoom room({});
  for (std::size_t i = 5000; i < room.points.size(); i += 7919)
    room.points[i] *= 0.5F; // far in front of the walls
  DepthRefinementReport report;
  const Cloud result = refined(cloudOf(room.points), &report);
  for (std::size_t i = 5000; i < room.points.size(); i += 7919)
    EXPECT_TRUE(std::isnan(result[i].x)) << i;
  EXPECT_LT(report.withdrawn, 40u);
}

TEST(DepthRefinement, keepsEdges)
{
  const DepthRoom room({});
  const Cloud result = refined(cloudOf(room.points));
  // there are no points between the box and the wall
  for (std::size_t i = 0; i < result.size(); ++i)
    if (std::isfinite(result[i].z)) {
      ASSERT_LT(std::abs(static_cast<double>(result[i].z) - room.true_depths[i]), 0.15);
    }
}

TEST(DepthRefinement, keepsOtherFieldsAndLeavesOutWhatIsNotChosen)
{
  const DepthRoom room({});
  const Cloud::Ptr cloud = cloudOf(room.points);
  DepthRefinement<PointNormal> refinement;
  refinement.setInputCloud(cloud);
  IndicesPtr half(new Indices(cloud->size() / 2));
  std::iota(half->begin(), half->end(), 0);
  refinement.setIndices(half);
  Cloud result;
  refinement.filter(result);
  ASSERT_EQ(result.size(), cloud->size());
  EXPECT_FALSE(result.is_dense);
  for (std::size_t i = half->size(); i < result.size(); ++i)
    ASSERT_TRUE(std::isnan(result[i].x));
  EXPECT_FALSE(std::isnan(result[100].x));
}

/** The planes of a room with their true pixels, like the output of a segmentation. */
std::vector<PlanePatch>
patchesOf(const DepthRoom& room)
{
  std::vector<PlanePatch> patches;
  for (const DepthRoom::Plane& plane : room.planes) {
    patches.emplace_back();
    patches.back().coefficients << -plane.normal, plane.distance;
  }
  return patches;
}

TEST(DepthRefinement, laysPixelsOntoThePlanesThatItIsGiven)
{
  const DepthRoom room({});
  const Cloud::Ptr cloud = cloudOf(room.points);
  DepthRefinement<PointNormal> refinement;
  refinement.setInputCloud(cloud);
  PointLabels labels(room.truth.begin(), room.truth.end());
  refinement.setPlanes(patchesOf(room), labels);
  Cloud result;
  refinement.filter(result);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (room.truth[i] >= 0 && std::isfinite((*cloud)[i].z)) {
      ASSERT_NEAR(result[i].z, room.true_depths[i], 1e-4) << i;
    }
  EXPECT_EQ(refinement.getReport().planes, room.planes.size());

  labels.pop_back();
  refinement.setPlanes(patchesOf(room), labels);
  EXPECT_THROW(refinement.filter(result), InitFailedException);
  labels.push_back(99);
  EXPECT_THROW(refinement.setPlanes(patchesOf(room), labels), BadArgumentException);
  std::vector<PlanePatch> through_sensor = patchesOf(room);
  through_sensor[0].coefficients[3] = 0;
  labels.back() = -1;
  EXPECT_THROW(refinement.setPlanes(through_sensor, labels), BadArgumentException);
}

TEST(DepthRefinement, doesNotFollowAPlaneBehindTheSensor)
{
  const DepthRoom room({});
  DepthRefinement<PointNormal> refinement;
  refinement.setInputCloud(cloudOf(room.points));
  std::vector<PlanePatch> behind(1);
  behind[0].coefficients << 0, 0, 1, 2; // z = -2
  refinement.setPlanes(behind, PointLabels(room.points.size(), 0));
  Cloud result;
  refinement.filter(result);
  EXPECT_EQ(refinement.getReport().on_planes, 0u);
  for (const PointNormal& point : result)
    ASSERT_FALSE(point.z <= 0);
}

TEST(DepthRefinement, isTheSameForAllNumbersOfThreads)
{
  const Cloud::Ptr cloud = cloudOf(depthOfCylinder({}, 0.4, 2.0));
  Cloud results[2];
  for (const unsigned threads : {1u, 8u}) {
    DepthRefinement<PointNormal> refinement;
    refinement.setNumberOfThreads(threads);
    refinement.setInputCloud(cloud);
    refinement.filter(results[threads == 1 ? 0 : 1]);
  }
  for (std::size_t i = 0; i < cloud->size(); ++i)
    ASSERT_TRUE(std::isnan(results[0][i].x)
                    ? std::isnan(results[1][i].x)
                    : results[0][i].getVector3fMap() == results[1][i].getVector3fMap());
}

TEST(DepthRefinement, refusesAndExplains)
{
  DepthRefinement<PointNormal> refinement;
  Cloud result;
  EXPECT_THROW(refinement.setInputCloud(nullptr), InitFailedException);
  EXPECT_THROW(refinement.filter(result), InitFailedException);
  const Cloud::Ptr row = cloudOf(DepthRoom({}).points);
  row->width = static_cast<std::uint32_t>(row->size());
  row->height = 1;
  refinement.setInputCloud(row);
  EXPECT_THROW(refinement.filter(result), UnorganizedPointCloudException);
  const Cloud::Ptr nothing = cloudOf(std::vector<Eigen::Vector3f>(
      DepthRoom::width * DepthRoom::height,
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN())));
  DepthRefinementReport report;
  EXPECT_EQ(refined(nothing, &report).size(), nothing->size());
  EXPECT_FALSE(report.remarks.empty());
  refinement.setInputCloud(cloudOf(DepthRoom({}).points));
  refinement.setProgressCallback([](double, const std::string&) { return false; });
  Cloud untouched(3, 1);
  EXPECT_THROW(refinement.filter(untouched), CancelledException);
  EXPECT_EQ(untouched.size(), 3u);
}

} // namespace
} // namespace pcl::acmap::test
