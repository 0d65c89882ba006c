#include "dewall_runs.h"
#include "run_tool.h"
#include "temporary_folder.h"
#include "test_data.h"

#include <pcl/conversions.h>
#include <pcl/core/point_cloud_file.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

void
expectGuarantees(const Cloud& cloud, DeWallRule rule)
{
  const DeWallRun run{rule, 0, 0};
  const DeWallResult result = triangulate(cloud, run);
  EXPECT_TRUE(keepsGuarantees(result, run)) << nameOf(rule);
  EXPECT_GE(static_cast<double>(result.report.used_points),
            0.97 * static_cast<double>(cloud.size()))
      << nameOf(rule);
}

/** The noise of a raw view exceeds its spacing, and the sensor is unknown. */
TEST(DeWallOnLargeCloud, rawView)
{
  const SimulatedObservation seen = observe(standardScene("corridor"), 40, 1);
  Cloud cloud;
  for (const ObservationPixel& pixel : seen.pixels)
    if (std::isfinite(pixel.x))
      cloud.emplace_back(pixel.x, pixel.y, pixel.z);
  expectGuarantees(cloud, DeWallRule::Guarded);
  expectGuarantees(cloud, DeWallRule::Dense);
}

/** The density decreases with the square of the distance from the scanner. */
TEST(DeWallOnLargeCloud, roomScan)
{
  const std::string path = "D_large/grenoble_room_5.2M.ply.xz";
  if (!hasTestData(path))
    GTEST_SKIP() << "no " << path << " in ACMAP_TEST_DATA";
  const TemporaryFolder folder;
  const std::filesystem::path packed = folder.path("room.ply.xz");
  std::filesystem::copy_file(testDataPath(path), packed);
  if (runTool("/usr/bin/env", {"xz", "-d", packed.string()}).exit_code != 0)
    GTEST_SKIP() << "no xz to unpack " << path;
  Cloud cloud;
  fromPCLPointCloud2(loadPointCloud(folder.path("room.ply")).cloud, cloud);
  expectGuarantees(cloud, DeWallRule::Guarded);
}

} // namespace
} // namespace pcl::acmap::test
