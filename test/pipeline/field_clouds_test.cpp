#include "test_data.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/plane_mapping.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace pcl::acmap::test {
namespace {

/** Clouds of others, by default settings; the right values stand beside them. */
class FieldClouds : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!hasTestData("H_field/clouds/room_y_up.ply"))
      GTEST_SKIP() << "H_field is not in the folder that ACMAP_TEST_DATA names";
  }

  const MappedPlanes&
  map(const std::string& name, SensorStatement sensor = SensorStatement::Unstated)
  {
    PointCloudFile file =
        loadPointCloud(testDataPath("H_field/clouds/" + name).string());
    file.sensor_statement = sensor;
    mapping_.setInputCloud(std::make_shared<const PointCloudFile>(std::move(file)));
    mapping_.compute(found_);
    return found_;
  }

  bool
  tells(const std::string& text) const
  {
    const std::vector<std::string>& remarks = mapping_.getReport().remarks;
    return std::any_of(remarks.begin(), remarks.end(), [&](const std::string& remark) {
      return remark.find(text) != std::string::npos;
    });
  }

  PlaneMapping mapping_;
  MappedPlanes found_;
};

TEST_F(FieldClouds, thinnedFlatsAreNoThickPlanes)
{
  for (const auto& [name, fewest] :
       {std::pair("flat_15000.ply", 15U), std::pair("flat_5000.ply", 5U)}) {
    const MappedPlanes& found = map(name);
    EXPECT_GE(found.planes.size(), fewest) << name;
    for (const PlanePatch& plane : found.planes)
      EXPECT_LT(plane.rms, 0.1) << name;
    const PlaneMappingReport& report = mapping_.getReport();
    EXPECT_TRUE(!report.consolidation || report.consolidation->voxel_size <= 0.5);
    EXPECT_GT(found.up.value_or(found.assumed_up).z(), 0.99F) << name;
  }
}

TEST_F(FieldClouds, aPhonesRoomHasItsFloorBelow)
{
  for (const char* name : {"room_y_up.ply", "room_y_up.obj"}) {
    const MappedPlanes& found = map(name);
    ASSERT_FALSE(found.planes.empty()) << name;
    EXPECT_GT(found.planes.front().coefficients.y(), 0.99) << name;
    EXPECT_NEAR(found.planes.front().area, 14.7, 0.7) << name;
    ASSERT_TRUE(found.up) << name;
    EXPECT_GT(found.up->y(), 0.999F) << name;
    EXPECT_EQ(mapping_.getReport().assessment->up.outcome, UpOutcome::Found) << name;
  }
}

TEST_F(FieldClouds, aFacadeStandsOnItsPavement)
{
  const MappedPlanes& found = map("facade_z_up.ply");
  EXPECT_GT(found.up.value_or(found.assumed_up).z(), 0.999F);
}

/** The second file has the points of the first one in another order, which therefore proves
 * no sensor. */
TEST_F(FieldClouds, invalidPointsAtZeroAreLeftOut)
{
  const MappedPlanes alone = map("xyz_only.ply", SensorStatement::NoSensor);
  EXPECT_FALSE(tells("(0, 0, 0)"));
  const MappedPlanes& with_zeros = map("half_zero.ply", SensorStatement::NoSensor);
  EXPECT_TRUE(tells("16145 points at (0, 0, 0)"));
  EXPECT_EQ(with_zeros.finite_points, alone.finite_points);
  EXPECT_EQ(with_zeros.labels.size(), 2 * alone.labels.size());
  ASSERT_NEAR(static_cast<double>(with_zeros.planes.size()),
              static_cast<double>(alone.planes.size()),
              1);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(
        with_zeros.planes[i].area, alone.planes[i].area, 0.05 * alone.planes[i].area);
}

TEST_F(FieldClouds, anUpDirectionThatIsStatedIsTaken)
{
  mapping_.setUpDirection({0, 0, -2});
  const MappedPlanes& found = map("room_y_up.ply");
  ASSERT_TRUE(found.up);
  EXPECT_EQ(*found.up, -Eigen::Vector3f::UnitZ());
  EXPECT_EQ(mapping_.getReport().assessment->up.outcome, UpOutcome::Stated);
}

} // namespace
} // namespace pcl::acmap::test
