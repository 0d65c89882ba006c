#include "clouds.h"
#include "consolidation_runs.h"
#include "map_points.h"

#include <pcl/conversions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

template <typename PointT>
typename PointCloud<PointT>::Ptr
makeSheet(std::uint64_t seed)
{
  Random random(seed);
  NoisyCloud sheet;
  sheet.addPatch(squarePatch(1, 0.3), 10000, 0.005, random);
  Cloud places;
  for (const Eigen::Vector3f& place : sheet.points)
    places.emplace_back(place.x(), place.y(), place.z());
  return copyOf<PointT>(places);
}

/** Whoever has a chain of filters calls them by a pointer to their base. */
TEST(BadInputByTheBase, isRefused)
{
  const auto cloud = makeSheet<PointXYZ>(1);
  VoxelConsolidation<PointXYZ> consolidation;
  Filter<PointXYZ>& filter = consolidation;
  PointCloud<PointXYZ> output;
  filter.setInputCloud(cloud);
  for (const index_t index : {-1, static_cast<int>(cloud->size())}) {
    filter.setIndices(std::make_shared<Indices>(Indices{0, index}));
    EXPECT_THROW(filter.filter(output), InitFailedException) << index;
  }
  const auto liar = std::make_shared<PointCloud<PointXYZ>>(*cloud);
  liar->height = 2;
  VoxelConsolidation<PointXYZ> other;
  other.setInputCloud(liar);
  EXPECT_THROW(other.filter(output), InitFailedException);
  VoxelConsolidation<PCLPointCloud2> of_rows;
  EXPECT_THROW(of_rows.setInputCloud(PCLPointCloud2::Ptr()), InitFailedException);
}

template <typename PointT>
class AnyPoint : public testing::Test {};

TYPED_TEST_SUITE(AnyPoint, MapPoints);

TYPED_TEST(AnyPoint, isConsolidated)
{
  const auto cloud = makeSheet<TypeParam>(1);
  cloud->header.frame_id = "map";
  cloud->header.stamp = 77;
  cloud->sensor_origin_ = Eigen::Vector4f(0.1F, 0.2F, -3, 1);
  cloud->sensor_orientation_ = Eigen::Quaternionf(0, 1, 0, 0);
  VoxelConsolidation<TypeParam> consolidation;
  consolidation.setInputCloud(cloud);
  consolidation.setVoxelSize(0.05);
  PointCloud<TypeParam> output;
  consolidation.filter(output);
  EXPECT_NEAR(static_cast<double>(output.size()), 420, 60);
  EXPECT_EQ(output.width, output.size());
  EXPECT_EQ(output.height, 1U);
  EXPECT_TRUE(output.is_dense);
  EXPECT_EQ(output.header.frame_id, "map");
  EXPECT_EQ(output.header.stamp, 77U);
  EXPECT_EQ(output.sensor_origin_, cloud->sensor_origin_);
  EXPECT_TRUE(output.sensor_orientation_.isApprox(cloud->sensor_orientation_));
  EXPECT_TRUE(consolidation.getSourceIndices().indices.empty()) << "nobody asked";
  EXPECT_TRUE(consolidation.getVoxelOfPoint().empty());
}

TYPED_TEST(AnyPoint, isConsolidatedInPlace)
{
  const auto cloud = makeSheet<TypeParam>(2);
  VoxelConsolidation<TypeParam> consolidation;
  consolidation.setVoxelSize(0.05);
  consolidation.setInputCloud(cloud);
  PointCloud<TypeParam> output;
  consolidation.filter(output);
  consolidation.filter(*cloud);
  ASSERT_EQ(cloud->size(), output.size());
  for (std::size_t i = 0; i < output.size(); ++i)
    EXPECT_EQ((*cloud)[i].getVector3fMap(), output[i].getVector3fMap());
}

TYPED_TEST(AnyPoint, isConsolidatedThroughTheBaseClass)
{
  const auto cloud = makeSheet<TypeParam>(3);
  VoxelConsolidation<TypeParam> consolidation;
  consolidation.setVoxelSize(0.05);
  Filter<TypeParam>& base = consolidation;
  base.setInputCloud(cloud);
  PointCloud<TypeParam> by_base, output;
  base.filter(by_base);
  EXPECT_GT(consolidation.getReport().representatives, 300U);
  consolidation.filter(output);
  ASSERT_EQ(by_base.size(), output.size());
  EXPECT_EQ(by_base.width, output.size());
  for (std::size_t i = 0; i < output.size(); ++i)
    EXPECT_EQ(by_base[i].getVector3fMap(), output[i].getVector3fMap());
  base.filter(*cloud);
  EXPECT_EQ(cloud->size(), output.size());
}

TEST(ConsolidationClass, wrongSettingsAreRefused)
{
  MapConsolidation consolidation;
  for (const double wrong : {-0.1, -1e-300, 2e9, double{nan}, double{infinity}})
    EXPECT_THAT([&] { consolidation.setVoxelSize(wrong); },
                testing::ThrowsMessage<BadArgumentException>(
                    testing::AllOf(testing::HasSubstr("voxel size"),
                                   testing::HasSubstr("[0,"),
                                   testing::HasSubstr(" m"))))
        << wrong;
  EXPECT_EQ(consolidation.getVoxelSize(), 0);
  for (const float wrong : {nan, infinity, -infinity, 1e10F})
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Vector3f viewpoint(1, 2, 3);
      viewpoint[axis] = wrong;
      EXPECT_THROW(consolidation.setViewpoints({{0, 0, 0}, viewpoint}),
                   BadArgumentException);
    }
  EXPECT_TRUE(consolidation.getViewpoints().empty());
  EXPECT_THROW(consolidation.setInputCloud(nullptr), InitFailedException);
}

TEST(ConsolidationClass, wrongIndicesAreRefused)
{
  MapConsolidation consolidation;
  consolidation.setInputCloud(makeSheet<MapPoint>(4));
  const auto size = static_cast<index_t>(makeSheet<MapPoint>(4)->size());
  MapCloud output;
  output.resize(3);
  for (const index_t wrong : {-1, size}) {
    consolidation.setIndices(std::make_shared<Indices>(Indices{0, 1, wrong}));
    EXPECT_THROW(consolidation.filter(output), InitFailedException);
    EXPECT_EQ(output.size(), 3U);
  }
}

TEST(ConsolidationClass, missingViewpointsAreRemarked)
{
  MapConsolidation consolidation;
  consolidation.setInputCloud(makeSheet<MapPoint>(5));
  consolidation.setVoxelSize(0.05);
  MapCloud output;
  consolidation.filter(output);
  ASSERT_GT(output.size(), 300U);
  EXPECT_FALSE(consolidation.getReport().remarks.empty());
  EXPECT_FALSE(consolidation.getReport().sensors_fit);
  for (const MapPoint& point : output)
    EXPECT_GT(point.getNormalVector3fMap().dot(output[0].getNormalVector3fMap()), 0.9F)
        << "neighbours agree";
}

TEST(ConsolidationClass, farPointsAreCountedAndRemarked)
{
  const auto cloud = makeSheet<MapPoint>(6);
  cloud->push_back(MapPoint());
  cloud->back().x = 1e9F;
  MapConsolidation consolidation;
  consolidation.setInputCloud(cloud);
  consolidation.setVoxelSize(0.05);
  consolidation.setKeepSources(true);
  MapCloud output;
  consolidation.filter(output);
  EXPECT_EQ(consolidation.getReport().distant_points, 1U);
  EXPECT_FALSE(consolidation.getReport().remarks.empty());
  EXPECT_NEAR(static_cast<double>(output.size()), 420, 60);
  EXPECT_EQ(consolidation.getVoxelOfPoint().back(), -1);
}

/** Degenerate clouds with an explicit voxel size. */
TEST(ConsolidationClass, uglyCloudsAreTaken)
{
  Cloud invalid;
  invalid.resize(50, PointXYZ(nan, nan, nan));
  const std::vector<std::pair<Cloud, std::size_t>> cases = {
      {{}, 0},
      {invalid, 0},
      {makeRandomBox(1, 1), 1},
      {makeCoincident(1000), 1},
      {makeCollinear(40), 40},
      {withOutlier(makeRandomBox(1, 1), 1e9F), 1},
      {withOutlier(makeCoincident(5), 1e9F), 1},
      {lacedWithNan(makeCollinear(40), 3), 40},
      {scaled(makeCollinear(40), 1e-20F), 1},
      {makeLattice(6), 216}};
  for (std::size_t k = 0; k < cases.size(); ++k) {
    VoxelConsolidation<PointXYZ> consolidation;
    consolidation.setInputCloud(cases[k].first.makeShared());
    consolidation.setVoxelSize(0.5);
    consolidation.setKeepSources(true);
    Cloud output;
    output.resize(7);
    consolidation.filter(output);
    EXPECT_EQ(output.size(), cases[k].second) << "case " << k;
    const ConsolidationReport& report = consolidation.getReport();
    EXPECT_EQ(report.points, cases[k].first.size()) << "case " << k;
    EXPECT_EQ(report.representatives, output.size()) << "case " << k;
    EXPECT_TRUE(std::isfinite(report.sigma) && std::isfinite(report.residual));
    EXPECT_EQ(consolidation.getSourceIndices().indices.size() + report.invalid_points +
                  report.distant_points,
              cases[k].first.size())
        << "case " << k;
    for (const PointXYZ& point : output)
      EXPECT_TRUE(point.getVector3fMap().allFinite()) << "case " << k;
  }
}

TEST(ConsolidationClass, oneSensorDoesNotSeeTheNextRoom)
{
  Cloud rooms = makeRoom(0.015, 0.2, 1);
  const auto fits = [&] {
    VoxelConsolidation<PointXYZ> consolidation;
    consolidation.setInputCloud(rooms.makeShared());
    consolidation.setVoxelSize(0.04);
    Cloud output;
    consolidation.filter(output);
    return consolidation.getReport().sensors_fit;
  };
  EXPECT_TRUE(fits()) << "from the centre of the room";
  rooms.sensor_origin_ = Eigen::Vector4f(-1.8F, 0.4F, 0.9F, 1);
  EXPECT_TRUE(fits()) << "from a corner";
  const Eigen::Isometry3d next(Eigen::Translation3d(0, 3.2, 0.3));
  rooms += moved(makeRoom(0.015, 0.2, 2), next);
  EXPECT_FALSE(fits());
}

TEST(ConsolidationClass, exactPlanesStayExact)
{
  for (const ExactPlane plane : {ExactPlane::Level, ExactPlane::Inclined}) {
    const auto cloud = copyOf<PointNormal>(makeGrid(40, 40, 0.0625, plane));
    cloud->sensor_origin_ = Eigen::Vector4f(1.25F, 1.25F, 9, 1);
    VoxelConsolidation<PointNormal> consolidation;
    consolidation.setInputCloud(cloud);
    consolidation.setVoxelSize(0.2);
    PointCloud<PointNormal> output;
    consolidation.filter(output);
    EXPECT_TRUE(consolidation.getReport().sensors_fit);
    const Eigen::Vector3f normal = plane == ExactPlane::Level
                                       ? Eigen::Vector3f(0, 0, 1)
                                       : Eigen::Vector3f(-1, 0, 1).normalized();
    for (const PointNormal& point : output) {
      EXPECT_NEAR(point.getVector3fMap().dot(normal), 0, 5e-5);
      EXPECT_GT(point.getNormalVector3fMap().dot(normal), 0.99999F);
      EXPECT_LT(point.curvature, 1e-5F);
    }
  }
}

TEST(VoxelConsolidationOfRows, TheInputThatWasSetLastCounts)
{
  const auto flat = [](int points) {
    PointCloud<PointXYZ> cloud;
    for (int i = 0; i < points; ++i)
      cloud.push_back(PointXYZ(0.01F * float(i % 50), 0.01F * float(i / 50), 1));
    const PCLPointCloud2::Ptr blob(new PCLPointCloud2);
    toPCLPointCloud2(cloud, *blob);
    return blob;
  };
  const PCLPointCloud2::Ptr many = flat(1000), few = flat(900);
  VoxelConsolidation<PCLPointCloud2> consolidation;
  consolidation.setVoxelSize(0.05);
  PCLPointCloud2 output;
  consolidation.setInputCloud(CloudRows(
      *many, LargeVector<std::uint8_t>(many->data.begin(), many->data.end())));
  consolidation.filter(output);
  EXPECT_EQ(consolidation.getReport().points, 1000U);
  consolidation.setInputCloud(few);
  consolidation.filter(output);
  EXPECT_EQ(consolidation.getReport().points, 900U);
}

} // namespace
} // namespace pcl::acmap::test
