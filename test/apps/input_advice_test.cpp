#include "input_advice.h"

#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(InputAdvice, IsOnlyForWrongDoors)
{
  const TemporaryFolder folder;
  const std::string log = folder.write("my.log", "");
  EXPECT_NE(toolForInput("pcl_entropy_rectification", "posed", log)
                .find("pcl_entropy_rectification --carmen " + log),
            std::string::npos);
  const std::string cloud = folder.write("a.pcd", "");
  EXPECT_EQ(toolForInput("pcl_dewall_surface", "input", cloud), "");
  EXPECT_EQ(toolForInput("pcl_plane_texturing", "observations", cloud), "");
  EXPECT_NE(toolForInput("pcl_plane_texturing", "planes", cloud), "");
  EXPECT_EQ(toolForInput("pcl_dewall_surface", "input", folder.path("none")), "");
}

} // namespace
} // namespace pcl::acmap::test
