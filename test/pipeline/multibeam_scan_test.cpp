#include "boxed_hall.h"
#include "scan_judgement.h"
#include "test_data.h"

#include <pcl/core/random.h>
#include <pcl/pipeline/plane_mapping.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

/** A scan of an empty hall, in which one ring is level with the sensor. */
PointCloud<PointXYZ>::Ptr
makeScan(int beams, double noise)
{
  constexpr int columns = 900;
  const BoxedHall hall{{Eigen::Vector3d(-9, -6, -1.4), Eigen::Vector3d(7, 8, 3)}, {}};
  constexpr double degree = M_PI / 180;
  Random random(3);
  const PointCloud<PointXYZ>::Ptr scan(new PointCloud<PointXYZ>);
  for (int column = 0; column < columns; ++column)
    for (int beam = 0; beam < beams; ++beam) {
      const double turn = 2 * M_PI * column / columns,
                   rise = (beam - beams / 2) * 40 * degree / beams;
      const Eigen::Vector3d ray(std::cos(rise) * std::cos(turn),
                                std::cos(rise) * std::sin(turn),
                                std::sin(rise) + 1e-9);
      const double range = hall.range(Eigen::Vector3d::Zero(), ray);
      const Eigen::Vector3d place = (range + noise * random.normal()) * ray;
      PointXYZ point;
      point.getVector3fMap() = place.cast<float>();
      scan->push_back(point);
    }
  return scan;
}

TEST(MultibeamScan, facesItsSensorAndClaimsNothingBetweenRings)
{
  for (const int beams : {16, 32, 64})
    for (const double noise : {0.0, 0.01}) {
      PlaneMapping mapping;
      mapping.setInputCloud(makeScan(beams, noise));
      MappedPlanes found;
      mapping.compute(found);
      ASSERT_TRUE(mapping.getReport().assessment);
      EXPECT_EQ(mapping.getReport().assessment->sensors.outcome, SensorOutcome::Proved);
      const ScanJudgement judged = judgeScan(found);
      EXPECT_GE(found.planes.size(), 5U) << beams << " " << noise;
      EXPECT_GT(judged.facing, 0.99 * judged.area) << beams << " " << noise;
      EXPECT_LT(judged.unsupported, 0.005 * judged.area) << beams << " " << noise;
      EXPECT_EQ(judged.through_sensor, 0U) << beams << " " << noise;
    }
}

TEST(MultibeamScan, hasPlanesThroughTheOriginIfNoSensorWasThere)
{
  Random random(4);
  const PointCloud<PointXYZ>::Ptr corner(new PointCloud<PointXYZ>);
  for (int i = 0; i < 20000; ++i) {
    const float a = static_cast<float>(4 * random.uniform()) - 2.0F,
                b = static_cast<float>(3 * random.uniform());
    corner->push_back(i % 2 ? PointXYZ(a, b, 0) : PointXYZ(a, 0, b)); // floor, wall
  }
  PlaneMapping mapping;
  mapping.setInputCloud(corner);
  MappedPlanes found;
  mapping.compute(found);
  EXPECT_FALSE(mapping.getReport().assessment->sensors.isKnown());
  ASSERT_EQ(found.planes.size(), 2U);
  EXPECT_EQ(judgeScan(found).through_sensor, 2U);
}

TEST(MultibeamScan, isProvedInRealScans)
{
  for (const char* name : {"rings_near_horizon.ply", "multibeam_room.ply"}) {
    const std::string path = "H_field/clouds/" + std::string(name);
    if (!hasTestData(path))
      GTEST_SKIP() << path << " is not in the folder that ACMAP_TEST_DATA names";
    PlaneMapping mapping;
    mapping.setInputCloud(std::make_shared<const PointCloudFile>(
        loadPointCloud(testDataPath(path).string())));
    MappedPlanes found;
    mapping.compute(found);
    const ScanJudgement judged = judgeScan(found);
    EXPECT_GE(found.planes.size(), 4U) << name;
    EXPECT_GE(judged.facing, 0.99 * judged.area) << name;
    EXPECT_LT(judged.unsupported, 0.001 * judged.area) << name;
    EXPECT_EQ(judged.through_sensor, 0U) << name;
  }
}

} // namespace
} // namespace pcl::acmap::test
