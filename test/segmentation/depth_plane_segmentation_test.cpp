#include "depth_room.h"

#include <pcl/core/exceptions.h>
#include <pcl/segmentation/depth_plane_segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace pcl::acmap::test {
namespace {

using Cloud = PointCloud<PointXYZ>;
using Segmentation = DepthPlaneSegmentation<PointXYZ>;

Cloud::Ptr
cloudOf(const std::vector<Eigen::Vector3f>& points, std::size_t width)
{
  Cloud::Ptr cloud(new Cloud);
  for (const Eigen::Vector3f& point : points)
    cloud->push_back({point.x(), point.y(), point.z()});
  cloud->width = static_cast<std::uint32_t>(width);
  cloud->height = static_cast<std::uint32_t>(points.size() / width);
  return cloud;
}

Cloud::Ptr
roomCloud(std::uint64_t seed = 1)
{
  DepthRoom::Camera camera;
  camera.seed = seed;
  return cloudOf(DepthRoom(camera).points, DepthRoom::width);
}

std::vector<PlanePatch>
planesOf(Segmentation& segmentation, const Cloud::ConstPtr& cloud)
{
  segmentation.setInputCloud(cloud);
  std::vector<PlanePatch> planes;
  segmentation.segment(planes);
  return planes;
}

Eigen::Vector3d
normalOf(const PlanePatch& plane)
{
  return plane.coefficients.head<3>();
}

TEST(DepthPlaneSegmentation, findsTheRoom)
{
  Segmentation segmentation;
  const std::vector<PlanePatch> planes = planesOf(segmentation, roomCloud());
  ASSERT_EQ(planes.size(), 5u);
  for (const PlanePatch& plane : planes) {
    EXPECT_NEAR(normalOf(plane).norm(), 1, 1e-9);
    EXPECT_GT(plane.coefficients[3], 0) << "the sensor is before the plane";
    EXPECT_NEAR(plane.coefficients.dot(plane.center.homogeneous()), 0, 0.01);
    Eigen::Matrix3d axes;
    axes << plane.axis_u, plane.axis_v, normalOf(plane);
    EXPECT_NEAR(axes.determinant(), 1, 1e-9);
    EXPECT_GT(plane.rms, 0);
    EXPECT_LT(plane.rms, 0.05);
  }
  const DepthPlaneReport& report = segmentation.getReport();
  EXPECT_EQ(report.planes, planes.size());
  EXPECT_EQ(report.points, DepthRoom::width * DepthRoom::height);
  EXPECT_NEAR(report.noise.step, 0.0029, 1e-4);
  EXPECT_GT(report.points_on_planes, 0.95 * static_cast<double>(report.points));
}

/** Twice the signed area of a loop, seen from the side of the normal. */
double
areaOf(const std::vector<Eigen::Vector3f>& loop, const PlanePatch& plane)
{
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = loop[i].cast<double>() - plane.center;
    const Eigen::Vector3d b = loop[(i + 1) % loop.size()].cast<double>() - plane.center;
    twice += a.cross(b).dot(normalOf(plane));
  }
  return twice / 2;
}

TEST(DepthPlaneSegmentation, outlinesWhatIsSeen)
{
  Segmentation segmentation;
  const std::vector<PlanePatch> planes = planesOf(segmentation, roomCloud());
  ASSERT_EQ(planes.size(), 5u);
  for (const PlanePatch& plane : planes) {
    double area = 0;
    for (const PlanePolygon& polygon : plane.polygons) {
      EXPECT_GT(areaOf(polygon.outer, plane), 0);
      area += areaOf(polygon.outer, plane);
      for (const auto& hole : polygon.holes) {
        EXPECT_LT(areaOf(hole, plane), 0);
        area += areaOf(hole, plane);
      }
      for (const Eigen::Vector3f& corner : polygon.outer)
        EXPECT_NEAR(
            plane.coefficients.dot(corner.cast<double>().homogeneous()), 0, 1e-4);
    }
    EXPECT_NEAR(area, plane.area, 1e-3 * plane.area);
  }
  // the side wall extends from the upper image border to the floor, and to the back
  // wall
  const auto side = std::find_if(planes.begin(), planes.end(), [](const PlanePatch& p) {
    return normalOf(p).x() < -0.9;
  });
  ASSERT_NE(side, planes.end());
  for (const Eigen::Vector3f& corner : side->polygons.front().outer) {
    EXPECT_LT(corner.y(), 1.3);
    EXPECT_LT(corner.z(), 4.1);
  }
}

TEST(DepthPlaneSegmentation, labelsArePlanesOfItsPoints)
{
  Segmentation segmentation;
  const Cloud::Ptr cloud = roomCloud();
  const std::vector<PlanePatch> planes = planesOf(segmentation, cloud);
  std::vector<PointIndices> clusters;
  segmentation.extract(clusters);
  ASSERT_EQ(clusters.size(), planes.size());
  std::size_t labelled = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    EXPECT_EQ(clusters[p].indices.size(), planes[p].support);
    labelled += clusters[p].indices.size();
    for (const index_t i : clusters[p].indices)
      ASSERT_EQ(segmentation.getLabels()[static_cast<std::size_t>(i)],
                static_cast<std::int32_t>(p));
  }
  EXPECT_EQ(labelled, segmentation.getReport().points_on_planes);
}

TEST(DepthPlaneSegmentation, covarianceHolds)
{
  // mean over many noise samples for the back wall: the normalised squared error is
  // about 1 per parameter
  double sum = 0;
  constexpr int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed) {
    Segmentation segmentation;
    const std::vector<PlanePatch> planes =
        planesOf(segmentation, roomCloud(static_cast<std::uint64_t>(seed)));
    const DepthRoom truth({});
    const PlanePatch& wall = *std::min_element(
        planes.begin(), planes.end(), [&](const PlanePatch& a, const PlanePatch& b) {
          return normalOf(a).dot(truth.planes[0].normal) <
                 normalOf(b).dot(truth.planes[0].normal);
        });
    const Eigen::Vector3d normal = -truth.planes[0].normal;
    const Eigen::Vector3d turn = normal / normal.dot(normalOf(wall));
    const Eigen::Vector3d error(-turn.dot(wall.axis_u),
                                -turn.dot(wall.axis_v),
                                -(normal.dot(wall.center) + truth.planes[0].distance) /
                                    normal.dot(normalOf(wall)));
    sum += error.dot(wall.covariance.inverse() * error) / 3;
  }
  EXPECT_GT(sum / seeds, 0.3);
  EXPECT_LT(sum / seeds, 4);
}

TEST(DepthPlaneSegmentation, leavesOutWhatIsNotChosen)
{
  Segmentation segmentation;
  const Cloud::Ptr cloud = roomCloud();
  IndicesPtr upper(new Indices(cloud->size() / 3));
  std::iota(upper->begin(), upper->end(), 0);
  segmentation.setInputCloud(cloud);
  segmentation.setIndices(upper);
  std::vector<PlanePatch> planes;
  segmentation.segment(planes);
  EXPECT_EQ(planes.size(), 2u) << "back wall and side wall";
  for (std::size_t i = upper->size(); i < cloud->size(); ++i)
    ASSERT_EQ(segmentation.getLabels()[i], -1);
}

TEST(DepthPlaneSegmentation, minAreaAndRightAngles)
{
  Segmentation segmentation;
  segmentation.setMinArea(3);
  for (const PlanePatch& plane : planesOf(segmentation, roomCloud()))
    EXPECT_GT(plane.area, 2.8);
  segmentation.setMinArea(0);
  segmentation.setRegularize(true);
  const std::vector<PlanePatch> planes = planesOf(segmentation, roomCloud());
  EXPECT_GT(segmentation.getReport().regular_planes, 0u);
  for (const PlanePatch& plane : planes)
    EXPECT_LT(std::abs(normalOf(plane).dot(normalOf(planes[1]))) *
                  (1 - std::abs(normalOf(plane).dot(normalOf(planes[1])))),
              0.12);
  EXPECT_THROW(segmentation.setMinArea(-1), BadArgumentException);
  EXPECT_THROW(segmentation.setMinArea(std::nan("")), BadArgumentException);
}

Cloud::Ptr
asRow(const Cloud& cloud)
{
  Cloud::Ptr row(new Cloud(cloud));
  row->width = static_cast<std::uint32_t>(row->size());
  row->height = 1;
  return row;
}

TEST(DepthPlaneSegmentation, putsAViewWithoutItsGapsBackIntoItsPicture)
{
  Segmentation organized, unorganized;
  const std::vector<PlanePatch> expected = planesOf(organized, roomCloud());
  const Cloud::Ptr row = asRow(*roomCloud());
  std::reverse(row->begin(), row->end());
  const std::vector<PlanePatch> found = planesOf(unorganized, row);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t p = 0; p < found.size(); ++p)
    EXPECT_LT((found[p].coefficients - expected[p].coefficients).norm(), 1e-6);
  PointLabels labels = unorganized.getLabels();
  std::reverse(labels.begin(), labels.end());
  EXPECT_EQ(labels, organized.getLabels());
  EXPECT_EQ(unorganized.getReport().points, row->size());
}

TEST(DepthPlaneSegmentation, refusesAndExplains)
{
  Segmentation segmentation;
  std::vector<PlanePatch> planes(3);
  EXPECT_THROW(segmentation.segment(planes), InitFailedException);
  Cloud::Ptr row = asRow(*roomCloud());
  for (PointXYZ& point : *row)
    point.x += 0.3F; // not the image of a camera at the origin
  segmentation.setInputCloud(row);
  EXPECT_THROW(segmentation.segment(planes), UnorganizedPointCloudException);
  EXPECT_EQ(planes.size(), 3u) << "untouched";
  segmentation.setInputCloud(roomCloud());
  segmentation.setIndices(IndicesPtr(new Indices{0, 1 << 30}));
  EXPECT_THROW(segmentation.segment(planes), InitFailedException);

  Segmentation ugly;
  const Eigen::Vector3f nothing =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  for (const Eigen::Vector3f& value : {nothing,
                                       Eigen::Vector3f(0, 0, 0),
                                       Eigen::Vector3f(1, 2, -3),
                                       Eigen::Vector3f(1e9F, 1e9F, 1e9F),
                                       Eigen::Vector3f(1e-30F, 0, 1e-30F)}) {
    const Cloud::Ptr cloud = cloudOf(std::vector<Eigen::Vector3f>(4800, value), 80);
    EXPECT_TRUE(planesOf(ugly, cloud).empty());
    EXPECT_FALSE(ugly.getReport().remarks.empty());
    EXPECT_EQ(ugly.getLabels(), PointLabels(cloud->size(), -1));
  }
  EXPECT_TRUE(planesOf(ugly, Cloud::Ptr(new Cloud)).empty());
  EXPECT_FALSE(ugly.getReport().remarks.empty());
}

TEST(DepthPlaneSegmentation, isTheSameAgain)
{
  Segmentation one, other;
  other.setNumberOfThreads(1);
  const std::vector<PlanePatch> a = planesOf(one, roomCloud());
  const std::vector<PlanePatch> b = planesOf(other, roomCloud());
  const std::vector<PlanePatch> again = planesOf(one, roomCloud());
  ASSERT_EQ(a.size(), b.size());
  ASSERT_EQ(a.size(), again.size());
  for (std::size_t p = 0; p < a.size(); ++p) {
    EXPECT_EQ(a[p].coefficients, b[p].coefficients);
    EXPECT_EQ(a[p].coefficients, again[p].coefficients);
    EXPECT_EQ(a[p].polygons.front().outer, b[p].polygons.front().outer);
  }
  EXPECT_EQ(one.getLabels(), other.getLabels());
}

TEST(DepthPlaneSegmentation, stopsWhenTold)
{
  Segmentation segmentation;
  segmentation.setInputCloud(roomCloud());
  segmentation.setProgressCallback([](double, const std::string&) { return false; });
  std::vector<PlanePatch> planes(2);
  EXPECT_THROW(segmentation.segment(planes), CancelledException);
  EXPECT_EQ(planes.size(), 2u);
}

} // namespace
} // namespace pcl::acmap::test
