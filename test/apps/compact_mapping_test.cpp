#include "compact_map_runs.h"
#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"
#include "virtual_display.h"

#include <pcl/pipeline/compact_mapping.h>
#include <pcl/texture/compact_map_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(CompactMapping, MakesAMapThatIsRead)
{
  const Corridor& made = corridor();
  for (const char* name :
       {"map.json", "map.obj", "map.mtl", "map.glb", "mesh.ply", "report.json"})
    EXPECT_TRUE(fs::exists(made.map + "/" + name)) << name;
  EXPECT_EQ(contentOf(made.map + "/map.glb").substr(0, 4), "glTF");
  const CompactMap map = loadCompactMap(made.map);
  EXPECT_GE(map.planes.size(), 5u);
  EXPECT_GE(map.charts.size(), map.planes.size());
  EXPECT_EQ(map.trajectory.poses.size(), 4u);
  std::size_t seen = 0;
  for (const TextureChart& chart : map.charts) {
    EXPECT_TRUE(fs::exists(made.map + "/" + chart.image)) << chart.image;
    for (const TexelKind kind : chart.kinds)
      seen += kind == TexelKind::Seen ? 1 : 0;
  }
  EXPECT_GT(seen, 50000u);
  const auto truth = jsonOfFile(made.session + "/truth.json");
  std::size_t found = 0;
  for (const auto& plane : truth.at("planes"))
    for (const PlanePatch& patch : map.planes)
      if (angleBetween(patch.coefficients, coefficientsOf(plane)) < 0.2 &&
          patch.area > 4 &&
          std::abs(patch.coefficients[3] - coefficientsOf(plane)[3]) < 0.01) {
        ++found;
        break;
      }
  EXPECT_GE(found, 4u);
  for (std::size_t p = 0; p < 4; ++p)
    EXPECT_GE(map.observations[p].size(), 2u) << p;
}

TEST(CompactMapping, MakesTheMapOfTheClass)
{
  const Corridor& made = corridor();
  pcl::CompactMapping mapping;
  mapping.setInputSequence(ObservationSequence(made.session), true);
  CompactMap map;
  mapping.compute(map);
  const TemporaryFolder folder;
  for (const std::string& name : saveCompactMap(folder.path(""), map))
    EXPECT_EQ(contentOf(folder.path(name)), contentOf(made.map + "/" + name)) << name;
}

TEST(CompactMapping, TellsHowCompactItIs)
{
  const Corridor& made = corridor();
  EXPECT_THAT(made.run.out, HasSubstr("compactness:"));
  EXPECT_THAT(made.run.out, HasSubstr("4 observations"));
  EXPECT_THAT(made.run.err, HasSubstr("no pictures"));
  EXPECT_EQ(made.run.errorLines(), 1u) << made.run.err;
  const auto report = jsonOfFile(made.map + "/report.json");
  const auto& bytes = report.at("bytes");
  EXPECT_EQ(bytes.at("raw"), report.at("finite_points").get<std::size_t>() * 16);
  EXPECT_EQ(bytes.at("map.glb"), fs::file_size(made.map + "/map.glb"));
  EXPECT_EQ(bytes.at("map.json"), fs::file_size(made.map + "/map.json"));
  EXPECT_EQ(bytes.at("textured"),
            bytes.at("map.glb").get<std::size_t>() -
                bytes.at("details").get<std::size_t>());
  // texels of a pixel's size
  EXPECT_LT(bytes.at("textured").get<double>() * 40, bytes.at("raw").get<double>());
  const auto& texture = report.at("texture");
  EXPECT_EQ(texture.at("pinholes"), 4);
  EXPECT_GT(texture.at("seen").get<double>(), 0.8 * texture.at("texels").get<double>());
  EXPECT_EQ(texture.at("gains").size(), 4u);
  EXPECT_EQ(report.at("observations"), 4);
}

constexpr std::array pictures = {
    "mesh.png", "planes.png", "outside.png", "inside.png", "floor_plan.png"};

TEST(CompactMapping, PicturesNeedAnXServer)
{
  const VirtualDisplay& display = VirtualDisplay::shared();
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  const TemporaryFolder folder;
  const std::string map = folder.path("map");
  RunSettings seeing;
  seeing.environment = {{"DISPLAY", std::string(std::getenv("DISPLAY"))}};
  const ToolRun run = runMapping({corridor().session, "-o", map}, seeing).succeeded();
  EXPECT_EQ(run.err, "");
  for (const char* name : pictures)
    EXPECT_EQ(contentOf(map + "/pictures/" + name).substr(0, 4), "\x89PNG") << name;
  const ToolRun without = runMapping(
      {corridor().session, "-o", folder.path("m2"), "--no-pictures"}, seeing);
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_EQ(without.err, "");
  for (const char* name : pictures)
    EXPECT_FALSE(fs::exists(folder.path("m2/pictures/") + name)) << name;
}

/** All others are drawn with VTK. */
TEST(CompactMapping, TheFloorPlanNeedsNoXServer)
{
  const std::string pictures_of_map = corridor().map + "/pictures/";
  EXPECT_EQ(contentOf(pictures_of_map + "floor_plan.png").substr(0, 4), "\x89PNG");
  EXPECT_FALSE(fs::exists(pictures_of_map + "outside.png"));
  EXPECT_THAT(contentOf(corridor().map + "/report.html"),
              HasSubstr("Floor plan: walls"));
}

TEST(CompactMapping, AnXServerThatEndsCostsThePicturesOnly)
{
  VirtualDisplay display("1280x960x24");
  if (!display.exists())
    GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
  const TemporaryFolder folder;
  const std::string map = folder.path("map");
  RunSettings seeing;
  seeing.environment = {{"DISPLAY", std::string(std::getenv("DISPLAY"))}};
  ToolRun run;
  {
    // the map is there before the first picture is drawn
    const StopAtFile stop(display, map + "/map.json");
    run = runMapping({corridor().session, "-o", map}, seeing);
  }
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("not all pictures could be drawn"));
  EXPECT_THAT(run.out, HasSubstr("compactness"));
  EXPECT_GT(loadCompactMap(map).planes.size(), 3u);
  for (const char* name : pictures) // none is broken
    if (const std::string path = map + "/pictures/" + name; fs::exists(path)) {
      EXPECT_EQ(contentOf(path).substr(0, 4), "\x89PNG");
    }
}

TEST(CompactMapping, OneColouredCloudDoes)
{
  const TemporaryFolder folder;
  const std::string map = folder.path("map");
  runMapping({corridor().merged, "-o", map}).succeeded();
  const auto report = jsonOfFile(map + "/report.json");
  EXPECT_EQ(report.at("texture").at("splatted"), 1);
  EXPECT_GT(report.at("texture").at("seen"), 20000);
  EXPECT_NE(contentOf(map + "/floor_plan.svg").find("</svg>"), std::string::npos);
  const CompactMap loaded = loadCompactMap(map);
  EXPECT_TRUE(loaded.trajectory.poses.empty());
  EXPECT_GE(loaded.planes.size(), 3u);
}

TEST(CompactMapping, WithoutColourAllIsGrey)
{
  const TemporaryFolder folder;
  const ToolRun run =
      runMapping({folder.write("room.pcd", roomPcd()), "-o", folder.path("map")})
          .succeeded();
  EXPECT_THAT(run.err, HasSubstr("colour"));
  const CompactMap map = loadCompactMap(folder.path("map"));
  EXPECT_EQ(map.planes.size(), 5u);
  for (const TextureChart& chart : map.charts)
    for (const std::uint8_t value : chart.colors.values)
      ASSERT_EQ(value, 128);
}

TEST(CompactMapping, ObservationsWithoutPosesNeedViewsInCommon)
{
  const TemporaryFolder folder;
  const std::string session = copyOfSession(folder.path("s"));
  fs::remove(session + "/trajectory.txt");
  // the VIEWPOINTs alone are sufficient
  EXPECT_EQ(runMapping({session, "-o", folder.path("m")}).exit_code, 0);
  EXPECT_EQ(
      runTexturing({corridor().planes, session, "-o", folder.path("t")}).exit_code, 0);
  for (int i = 0; i < 4; ++i)
    changeViewpoint(observation(session, i), [](auto& cloud) {
      cloud.sensor_origin_.setZero();
      cloud.sensor_orientation_.setIdentity();
    });
  // neighbours look 60 degrees apart, too far for egomotion
  expectRefused(
      runMapping({session, "-o", folder.path("m2")}), 4, "could be joined to another");
  expectRefused(runTexturing({corridor().planes, session, "-o", folder.path("t2")}),
                3,
                "have no poses");
  EXPECT_EQ(folder.count(), 3);
  // rotations about one position count as poses
  for (int i = 0; i < 4; ++i)
    changeViewpoint(observation(session, i), [i](auto& cloud) {
      cloud.sensor_orientation_ =
          Eigen::AngleAxisf(0.1F * static_cast<float>(i), Eigen::Vector3f::UnitY());
    });
  const ToolRun turned = runMapping({session, "-o", folder.path("m3")});
  EXPECT_EQ(turned.err.find("have no poses"), std::string::npos) << turned.err;
}

TEST(CompactMapping, FoldersOfNoUseAreRefused)
{
  const TemporaryFolder folder;
  const std::string out = folder.path("m");
  fs::create_directory(folder.path("empty"));
  expectRefused(runMapping({folder.path("empty"), "-o", out}), 3, "no .pcd");
  expectRefused(runMapping({folder.path("none"), "-o", out}), 3, "none");
  const std::string session = copyOfSession(folder.path("s"));
  const std::string trajectory = session + "/trajectory.txt";
  const std::string whole = contentOf(trajectory);
  folder.write("s/trajectory.txt",
               whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  expectRefused(runMapping({session, "-o", out}), 3, "observation_0003.pcd");
  folder.write("s/trajectory.txt", "garbage\n");
  expectRefused(runMapping({session, "-o", out}), 3, "trajectory.txt");
  folder.write("s/trajectory.txt", "0 nan 0 0 0 0 0 1\n");
  expectRefused(runMapping({session, "-o", out}), 3, "trajectory.txt");
  EXPECT_EQ(folder.count(), 2);
}

TEST(CompactMapping, BrokenObservationsStopOrAreSkipped)
{
  const TemporaryFolder folder;
  const std::string session = copyOfSession(folder.path("s"));
  const std::string whole = contentOf(observation(session, 1));
  folder.write("s/observation_0001.pcd", whole.substr(0, whole.size() / 2));
  expectRefused(
      runMapping({session, "-o", folder.path("m")}), 3, "observation_0001.pcd");
  EXPECT_EQ(folder.count(), 1);
  const ToolRun run = runMapping({session, "-o", folder.path("m"), "--skip-broken"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("observation_0001.pcd"));
  const CompactMap map = loadCompactMap(folder.path("m"));
  EXPECT_EQ(map.trajectory.poses.size(), 3u);
  for (const auto& observations : map.observations)
    for (const std::int32_t number : observations)
      EXPECT_LT(number, 3);
  for (int i = 0; i < 4; ++i)
    folder.write("s/observation_000" + std::to_string(i) + ".pcd", "VERSION");
  expectRefused(runMapping({session, "-o", folder.path("m2"), "--skip-broken"}),
                3,
                "none of the observations");
}

TEST(CompactMapping, ViewpointsThatDisagreeAreTold)
{
  const TemporaryFolder folder;
  const std::string session = copyOfSession(folder.path("s"));
  changeViewpoint(observation(session, 2),
                  [](auto& cloud) { cloud.sensor_origin_.x() += 0.01F; });
  const ToolRun run = runMapping({session, "-o", folder.path("m")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("observation_0002.pcd: its VIEWPOINT is 0.01"));
  EXPECT_EQ(run.errorLines(), 2u) << run.err; // the other line: no pictures
  EXPECT_EQ(contentOf(folder.path("m/map.json")), contentOf(corridor().planes));
}

TEST(CompactMapping, PlacesThatCannotBeAreRefused)
{
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  expectRefused(runMapping({corridor().session, "-o", file}), 5, "file");
  EXPECT_EQ(contentOf(file), "mine");
  expectRefused(
      runMapping({corridor().session, "-o", folder.path("none/m")}), 5, "none");
  expectRefused(runMapping({corridor().session}), 2, "--output");
  expectRefused(runMapping({corridor().session, "-o", folder.path("m"), "--nonsense"}),
                2,
                "--help");
  expectRefused(
      runMapping({corridor().session, "-o", folder.path("m"), "--texel", "-1"}),
      2,
      "--texel");
  expectRefused(runMapping({corridor().session,
                            "-o",
                            folder.path("m"),
                            "--report",
                            folder.path("none/r.json")}),
                5,
                "none");
  EXPECT_EQ(folder.count(), 1);
}

TEST(CompactMapping, FullDiskAndInterruptionLeaveNothing)
{
  const TemporaryFolder folder;
  const std::string out = folder.path("m");
  RunSettings full;
  full.file_size_limit = 20000;
  full.environment = {{"DISPLAY", std::nullopt}};
  expectRefused(runMapping({corridor().session, "-o", out}, full), 5, "m/");
  RunSettings interrupted;
  interrupted.interrupt_after = 0.3;
  expectRefused(
      runMapping({corridor().session, "-o", out, "--texel", "0.005"}, interrupted),
      130,
      "interrupted");
  EXPECT_EQ(folder.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
