#include "test_data.h"

#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/random.h>
#include <pcl/pipeline/plane_mapping.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pcl::acmap::test {
namespace {

/** What the tests ask of the planes of a scan. */
struct Judgement {
  double area = 0, facing = 0; ///< square metres, of all outlines
  double unsupported = 0; ///< planes whose outline is more than twice their triangles
  std::size_t through_sensor = 0;
};

Judgement
judge(const MappedPlanes& found)
{
  std::vector<double> triangles(found.planes.size(), 0.0);
  const PointView points = requirePoints(found.vertices);
  for (const TriangleMesh::Triangle& t : found.mesh.triangles) {
    std::int32_t plane = -1;
    bool is_one = true;
    for (const std::int32_t corner : t) {
      const std::int32_t label = found.vertex_labels[static_cast<std::size_t>(corner)];
      is_one = is_one && (label < 0 || plane < 0 || label == plane);
      plane = std::max(plane, label);
    }
    if (!is_one || plane < 0)
      continue;
    const auto corner = [&](std::size_t k) -> Eigen::Vector3f {
      return points[static_cast<std::size_t>(t[k])];
    };
    triangles[static_cast<std::size_t>(plane)] +=
        (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
  }
  Judgement result;
  for (std::size_t p = 0; p < found.planes.size(); ++p) {
    const PlanePatch& plane = found.planes[p];
    result.area += plane.area;
    result.facing += plane.coefficients[3] > 0 ? plane.area : 0;
    result.unsupported += plane.area > 2 * triangles[p] ? plane.area : 0;
    result.through_sensor += std::abs(plane.coefficients[3]) < 0.01 ? 1 : 0;
  }
  return result;
}

/** Range of a ray from the origin to the walls of a hall. */
double
rangeInHall(const Eigen::Vector3d& ray)
{
  const Eigen::Vector3d low(-9, -6, -1.4), high(7, 8, 3);
  double range = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    range = std::min(range, (ray[axis] > 0 ? high : low)[axis] / ray[axis]);
  return range;
}

/** A scan of the hall, in which one ring is level with the sensor. */
PointCloud<PointXYZ>::Ptr
makeScan(int beams, double noise)
{
  constexpr int columns = 900;
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
      const Eigen::Vector3d place = (rangeInHall(ray) + noise * random.normal()) * ray;
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
      const Judgement judged = judge(found);
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
  EXPECT_EQ(judge(found).through_sensor, 2U);
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
    const Judgement judged = judge(found);
    EXPECT_GE(found.planes.size(), 4U) << name;
    EXPECT_GE(judged.facing, 0.99 * judged.area) << name;
    EXPECT_LT(judged.unsupported, 0.001 * judged.area) << name;
    EXPECT_EQ(judged.through_sensor, 0U) << name;
  }
}

} // namespace
} // namespace pcl::acmap::test
