#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"
#include "virtual_display.h"

#include <gtest/gtest.h>

namespace pcl::acmap::test {
namespace {

TEST(PlanePicture, AMissingXServerCostsThePictureOnly)
{
  const TemporaryFolder folder;
  const std::string input = folder.write("room.pcd", roomPcd());
  const std::string planes = folder.path("p.json"), picture = folder.path("p.png");
  RunSettings blind;
  blind.environment = {{"DISPLAY", std::nullopt}};
  const ToolRun run = runPlanes({input, planes, "--picture", picture}, blind);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("xvfb-run"), std::string::npos) << run.err;
  EXPECT_EQ(run.out.find(picture), std::string::npos) << run.out;
  EXPECT_EQ(jsonOfFile(planes)["planes"].size(), 5u);
  EXPECT_EQ(folder.count(), 2);
}

TEST(PlanePicture, ShowsThePlanesAsTheViewerDoes)
{
  const VirtualDisplay& display = VirtualDisplay::shared();
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  const TemporaryFolder folder;
  const std::string input = folder.write("room.pcd", roomPcd());
  const std::string picture = folder.path("p.png");
  const std::string mesh = folder.path("mesh.ply");
  runPlanes({input, folder.path("p.json"), "--picture", picture, "--normals", mesh})
      .succeeded();
  const std::string png = contentOf(picture);
  EXPECT_EQ(png.substr(0, 4), "\x89PNG");
  const auto shoot = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments =
        joined({mesh, "--screenshot", folder.path("v.png")}, more);
    EXPECT_EQ(runViewer(arguments).exit_code, 0);
    return contentOf(folder.path("v.png"));
  };
  EXPECT_EQ(shoot({"--labels", "--hide-backs"}), png);
  EXPECT_NE(shoot({"--hide-backs"}), png);
  expectRefused(
      runViewer({input, "--labels", "--screenshot", folder.path("v.png")}), 2, "label");
}

} // namespace
} // namespace pcl::acmap::test
