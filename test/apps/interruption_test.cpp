#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>

#include <csignal>

namespace pcl::acmap::test {
namespace {

TEST(Interruption, LeavesNothingBehind)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", planePcd(1000));
  RunSettings interrupted;
  interrupted.interrupt_after = 0.7;
  expectRefused(
      runSurface({input, folder.path("out.ply")}, interrupted), 130, "interrupted");
  EXPECT_EQ(folder.count(), 1);
}

TEST(Interruption, LeavesNoPlanesBehind)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("in.pcd", planePcd(1000));
  RunSettings interrupted;
  interrupted.interrupt_after = 0.3;
  expectRefused(runPlanes({input,
                           folder.path("out.json"),
                           "--labels",
                           folder.path("labels.pcd"),
                           "--normals",
                           folder.path("normals.ply")},
                          interrupted),
                130,
                "interrupted");
  EXPECT_EQ(folder.count(), 1);
}

} // namespace
} // namespace pcl::acmap::test
