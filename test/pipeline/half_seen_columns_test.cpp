#include "half_seen_room.h"
#include "test_data.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/pipeline/plane_mapping.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace pcl::acmap::test {
namespace {

MappedPlanes
mapped(PlaneMapping& mapping)
{
  mapping.setComputeCylinders(true);
  MappedPlanes result;
  mapping.compute(result);
  return result;
}

const CylinderPatch*
patchOn(const SceneCylinder& truth, const MappedPlanes& found)
{
  for (const CylinderPatch& patch : found.cylinders) {
    const Eigen::Vector3d way = patch.axis_point - truth.point;
    if ((way - way.dot(truth.axis) * truth.axis).norm() < 0.2 * truth.radius &&
        std::abs(patch.axis_direction.dot(truth.axis)) > 0.99 &&
        std::abs(patch.radius - truth.radius) < 0.2 * truth.radius)
      return &patch;
  }
  return nullptr;
}

/** Is a plane on a column instead of a wall or the floor? */
bool
isStrip(const PlanePatch& plane, const SceneCylinder& column)
{
  const Eigen::Vector3d from = plane.center - column.point;
  return (from - from.dot(column.axis) * column.axis).norm() < 1.2 * column.radius &&
         std::abs(plane.coefficients.head<3>().dot(column.axis)) < 0.5;
}

void
expectColumns(const HalfSeenRoom& room,
              const MappedPlanes& found,
              const std::string& name)
{
  EXPECT_EQ(found.cylinders.size(), room.columns.size()) << name;
  for (const SceneCylinder& column : room.columns) {
    const CylinderPatch* const patch = patchOn(column, found);
    if (!patch) {
      ADD_FAILURE() << name << ": no column of radius " << column.radius;
      continue;
    }
    EXPECT_NEAR(patch->radius, column.radius, 0.004) << name;
    for (const PlanePatch& plane : found.planes)
      EXPECT_FALSE(isStrip(plane, column)) << name << ' ' << column.radius;
  }
}

TEST(HalfSeenColumns, areFoundByTheMappingWithAndWithoutASensor)
{
  for (const double sigma : {0.002, 0.006, 0.01})
    for (const double density : {800.0, 3000.0})
      for (const bool is_along_rays : {false, true}) {
        HalfSeenSettings settings{sigma, density, is_along_rays};
        settings.seed = static_cast<std::uint64_t>(density + 1e3 * sigma);
        const HalfSeenRoom room = makeHalfSeenRoom(settings);
        ASSERT_FALSE(room.columns.empty());
        for (const bool has_sensor : {false, true}) {
          room.cloud->sensor_origin_.head<3>() =
              has_sensor ? room.sensor : Eigen::Vector3f::Zero().eval();
          PlaneMapping mapping;
          mapping.setInputCloud(room.cloud);
          expectColumns(room,
                        mapped(mapping),
                        std::to_string(sigma) + " m, " + std::to_string(density) +
                            (is_along_rays ? " along rays" : "") +
                            (has_sensor ? " with sensor" : ""));
        }
      }
}

TEST(HalfSeenColumns, ofFilesAreOneCylinder)
{
  for (const std::string name : {"half_seen_column_3mm", "half_seen_column_10mm"}) {
    const std::string path = "H_field/clouds/" + name + ".ply";
    if (!hasTestData(path))
      GTEST_SKIP() << "the test data is missing";
    PlaneMapping mapping;
    mapping.setInputCloud(std::make_shared<const PointCloudFile>(
        loadPointCloud(testDataPath(path).string())));
    const MappedPlanes found = mapped(mapping);
    HalfSeenRoom room;
    room.columns.push_back({{1.7, 0, 1.6}, Eigen::Vector3d::UnitY(), 0.15});
    expectColumns(room, found, name);
    EXPECT_EQ(found.planes.size(), 3U) << name;
    ASSERT_EQ(found.cylinders.size(), 1U) << name;
    EXPECT_NEAR(found.cylinders[0].radius, 0.15, 0.003) << name;
  }
}

} // namespace
} // namespace pcl::acmap::test
