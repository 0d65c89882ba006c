#include "filtered_observations.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::test {
namespace {

using Scans = std::vector<PointCloud<PointNormal>::Ptr>;
using Rectifier = EntropyRectification<PointNormal>;

template <typename PointT>
class RegisteringFilterOf : public testing::Test {};

#ifdef ACMAP_FEW_POINT_TYPES
using FilteredTypes = testing::Types<PointXYZ, PointXYZRGB, PointNormal>;
#else
using FilteredTypes = testing::Types<PointXYZ, PointXYZI, PointXYZRGB, PointNormal>;
#endif

TYPED_TEST_SUITE(RegisteringFilterOf, FilteredTypes);

TYPED_TEST(RegisteringFilterOf, givesWhatTheCallsOfLumGive)
{
  expectFilterOfAllAndOfSome<TypeParam, EntropyRectification<TypeParam>>();
}

TEST(RegisteringFilter, adjustsPlanesToo)
{
  expectFilterOfAllAndOfSome<PointXYZ, PlaneAdjustment<PointXYZ>>();
}

/** The last cloud need not be added by a call. */
template <typename Filter>
void
addAllButTheLast(const Scans& scans, Rectifier& rectifier, Filter& filter)
{
  for (std::size_t i = 0; i < scans.size(); ++i) {
    filter.setInputCloud(scans[i]);
    if (i + 1 < scans.size())
      rectifier.addPointsFromInputCloud();
  }
}

TEST(RegisteringFilter, worksByAPointerToPclsFilter)
{
  const Scans scans = posedScans<PointNormal>();
  Rectifier lum;
  const auto wanted = mapByLum<Rectifier, PointNormal>(lum, scans);
  ASSERT_EQ(lum.getReport().outcome, RectificationOutcome::Rectified);
  const Rectifier::Ptr rectifier(new Rectifier);
  const Filter<PointNormal>::Ptr filter = rectifier;
  addAllButTheLast(scans, *rectifier, *filter);
  PointCloud<PointNormal> map;
  filter->filter(map);
  EXPECT_TRUE(haveSameBytes(map, wanted));
}

TEST(RegisteringFilter, addsACloudOnceAndFiltersAgain)
{
  const Scans scans = posedScans<PointNormal>();
  Rectifier rectifier;
  addAllButTheLast(scans, rectifier, rectifier);
  PointCloud<PointNormal> first, second;
  rectifier.filter(first);
  rectifier.setInputCloud(scans.back());
  rectifier.filter(second);
  EXPECT_EQ(rectifier.getNumberOfPointClouds(), scans.size());
  EXPECT_TRUE(haveSameBytes(first, second));

  rectifier.clear();
  EXPECT_EQ(rectifier.getNumberOfPointClouds(), 0U);
  EXPECT_EQ(rectifier.addPointsFromInputCloud(), 0U)
      << "it is an input of the next map";
}

TEST(RegisteringFilter, mayFilterInPlace)
{
  const Scans scans = posedScans<PointNormal>();
  Rectifier lum, rectifier;
  const auto wanted = mapByLum<Rectifier, PointNormal>(lum, scans);
  addAllButTheLast(scans, rectifier, rectifier);
  rectifier.filter(*scans.back());
  EXPECT_TRUE(haveSameBytes(*scans.back(), wanted));
  EXPECT_TRUE(haveSameBytes(*rectifier.getConcatenatedCloud(), wanted))
      << "the observation is still what it was";
}

/** LUM's and the filter's calls add to one list. */
TEST(RegisteringFilter, takesCloudsOfBothCalls)
{
  const Scans scans = posedScans<PointNormal>();
  Rectifier lum, rectifier;
  const auto wanted = mapByLum<Rectifier, PointNormal>(lum, scans);
  for (const auto& scan : scans)
    rectifier.addPointCloud(scan, poseOfSensor(*scan));
  PointCloud<PointNormal> map;
  rectifier.filter(map);
  EXPECT_TRUE(haveSameBytes(map, wanted)) << "without an input cloud";
}

/** An output that no run can make. */
PointCloud<PointNormal>
noMap()
{
  PointCloud<PointNormal> cloud;
  cloud.resize(7);
  return cloud;
}

template <typename Exception>
void
expectRefused(Rectifier& rectifier, const std::string& words)
{
  auto map = noMap();
  const std::size_t before = rectifier.getNumberOfPointClouds();
  try {
    rectifier.filter(map);
    ADD_FAILURE() << "not refused: " << words;
  }
  catch (const Exception& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
  EXPECT_TRUE(haveSameBytes(map, noMap()));
  EXPECT_EQ(rectifier.getNumberOfPointClouds(), before);
}

TEST(RegisteringFilter, refusesBadInputAndSaysWhy)
{
  Rectifier rectifier;
  expectRefused<InitFailedException>(rectifier, "no input cloud was set");
  EXPECT_THROW(rectifier.addPointsFromInputCloud(), InitFailedException);
  EXPECT_THROW(rectifier.setInputCloud(nullptr), InitFailedException);
  const Scans scans = posedScans<PointNormal>();
  const auto size = static_cast<index_t>(scans[0]->size());
  rectifier.setInputCloud(scans[0]);
  for (const index_t bad : {-1, size}) {
    rectifier.setIndices(IndicesPtr(new Indices{0, bad}));
    expectRefused<InitFailedException>(rectifier, "outside of the input cloud");
  }
  rectifier.setIndices(IndicesPtr());
  const PointCloud<PointNormal>::Ptr cloud(new PointCloud<PointNormal>(*scans[0]));
  rectifier.setInputCloud(cloud);
  cloud->width = 3;
  cloud->height = 2;
  expectRefused<InitFailedException>(rectifier, "claims 3 x 2 points");
  *cloud = *scans[0];
  for (const float bad :
       {std::nanf(""), std::numeric_limits<float>::infinity(), 1e30F}) {
    cloud->sensor_origin_.x() = bad;
    expectRefused<BadArgumentException>(rectifier, "pose");
  }
  *cloud = *scans[0];
  PointCloud<PointNormal> map;
  rectifier.filter(map);
  EXPECT_EQ(map.size(), cloud->size());
}

TEST(RegisteringFilter, keepsPointsThatAreNotFinite)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Scans scans = posedScans<PointNormal>();
  for (const auto& scan : scans) {
    (*scan)[5].x = nan;
    scan->is_dense = false;
  }
  scans[1]->clear();
  scans[2]->points.assign(40, PointNormal(nan, nan, nan));
  scans[2]->width = 40;
  Rectifier lum, rectifier;
  const auto wanted = mapByLum<Rectifier, PointNormal>(lum, scans);
  const auto map = mapByFilter<Rectifier, PointNormal>(rectifier, scans);
  std::size_t points = 0, invalid = 0;
  for (const auto& scan : scans)
    points += scan->size();
  for (const PointNormal& point : map)
    invalid += std::isfinite(point.x) ? 0 : 1;
  EXPECT_EQ(map.size(), points);
  EXPECT_EQ(invalid, scans.size() - 2 + 40);
  EXPECT_FALSE(map.is_dense);
  EXPECT_TRUE(haveSameBytes(map, wanted));
}

TEST(RegisteringFilter, ofNothingIsNothingWithAReason)
{
  Rectifier rectifier;
  for (int i = 0; i < 2; ++i) {
    rectifier.setInputCloud(PointCloud<PointNormal>::Ptr(new PointCloud<PointNormal>));
    EXPECT_EQ(rectifier.addPointsFromInputCloud(), static_cast<std::size_t>(i));
  }
  auto map = noMap();
  rectifier.filter(map);
  EXPECT_TRUE(map.empty());
  EXPECT_EQ(rectifier.getReport().outcome, RectificationOutcome::Undetermined);
  EXPECT_FALSE(rectifier.getReport().remarks.empty());
}

} // namespace
} // namespace pcl::acmap::test
