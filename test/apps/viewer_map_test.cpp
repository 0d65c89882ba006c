#include "room_map.h"
#include "shown_picture.h"
#include "temporary_folder.h"
#include "tool_cases.h"
#include "virtual_display.h"

#include <pcl/core/file_format.h>
#include <pcl/core/map_file.h>
#include <pcl/texture/compact_map_folder.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

class ViewerOfMaps : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!display_.exists())
      GTEST_SKIP() << "there is no X server, and Xvfb is not installed";
    CompactMap map = makeRoomMap();
    map.trajectory = makeRoomWay();
    saveCompactMap(room_, map);
  }

  ToolRun
  run(const std::string& input, std::vector<std::string> more = {})
  {
    fs::remove(picture_);
    return runViewer(
        joined({input, "--screenshot", picture_, "--size", "320x240"}, more));
  }

  ShownPicture
  shoot(const std::string& input, const std::vector<std::string>& more = {})
  {
    const ToolRun done = run(input, more);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return ShownPicture(picture_);
  }

  /** \brief Adds a carpet above the floor, next to the map. */
  void
  addMeshAndCloud()
  {
    PointCloud<PointXYZ> carpet;
    for (int row = 0; row < 20; ++row)
      for (int column = 0; column < 20; ++column)
        carpet.emplace_back(0.1F * static_cast<float>(column) - 1,
                            1 + 0.02F * static_cast<float>((row * 7 + column * 3) % 5),
                            0.1F * static_cast<float>(row) - 1);
    const std::string cloud = folder_.write("room/map.pcd", pcdText(carpet));
    runSurface({cloud, folder_.path("room/mesh.ply")}).succeeded();
  }

  /** \brief Replaces a part of map.json. */
  void
  edit(const std::string& part, const std::string& by)
  {
    std::string text = contentOf(folder_.path("room/map.json"));
    const std::size_t place = text.find(part);
    ASSERT_NE(place, std::string::npos) << text.substr(0, 200);
    folder_.write("room/map.json", text.replace(place, part.size(), by));
  }

  void
  expectNoPicture(const ToolRun& run, int exit_code, const std::string& word)
  {
    expectRefused(run, exit_code, word);
    EXPECT_FALSE(fs::exists(picture_));
  }

  const VirtualDisplay& display_ = VirtualDisplay::shared();
  TemporaryFolder folder_;
  std::string room_ = folder_.path("room");
  std::string picture_ = folder_.path("out.png");
};

bool
isRed(const ShownPicture::Pixel& p)
{
  return p[0] > 2 * p[1] && p[0] > 2 * p[2] && p[0] > 90;
}

TEST_F(ViewerOfMaps, ShowsFoldersWithTheirColours)
{
  EXPECT_GT(shoot(room_).share(isRed), 0.05);
  EXPECT_LT(shoot(room_, {"--layers", "planes"}).share(isRed), 0.01);
}

TEST_F(ViewerOfMaps, ShowsPlanesOfAFileWithoutColours)
{
  const ShownPicture planes = shoot(folder_.path("room/map.json"));
  EXPECT_GT(planes.covered(), 0.2);
  EXPECT_LT(planes.share(isRed), 0.01);
  const std::string bare = folder_.path("planes.json");
  CompactMap map = makeRoomMap();
  map.charts.clear();
  saveMapFile(bare, map);
  EXPECT_GT(shoot(bare).covered(), 0.2);
}

/** As other programs show an OBJ, and as map.obj is written. */
TEST_F(ViewerOfMaps, AnObjHasYUp)
{
  std::string points;
  const auto addTile = [&](double y, const std::string& color) {
    for (const auto& [x, z] : {std::pair{-1, -1}, {1, -1}, {1, -5}, {-1, -5}})
      points += "v " + std::to_string(x) + " " + std::to_string(y) + " " +
                std::to_string(z) + color + "\n";
  };
  addTile(0.5, " 1 0 0");
  addTile(-0.5, " 0 0 1");
  const std::string obj = folder_.write("tiles.obj", points + "f 4 3 2 1\nf 5 6 7 8\n");
  const ShownPicture picture = shoot(obj, {"--from", "0", "0", "4"});
  const auto is_upper = [](const ShownPicture::Pixel& p) {
    return p[0] > 2 * p[1] && p[0] > 2 * p[2] && p[0] > 40;
  };
  const auto is_lower = [](const ShownPicture::Pixel& p) {
    return p[2] > 2 * p[0] && p[2] > 2 * p[1] && p[2] > 40;
  };
  ASSERT_GT(picture.share(is_upper), 0.005);
  ASSERT_GT(picture.share(is_lower), 0.005);
  EXPECT_LT(picture.middle(is_upper)[1], 0.5);
  EXPECT_GT(picture.middle(is_lower)[1], 0.5);
}

TEST_F(ViewerOfMaps, LayersAreChosenOneByOne)
{
  addMeshAndCloud();
  const ShownPicture bare = shoot(room_, {"--layers", "trajectory"});
  std::vector<std::vector<ShownPicture::Pixel>> seen = {bare.pixels};
  for (const char* layers :
       {"points", "mesh", "normals", "planes", "texture", "mesh,texture"}) {
    const ShownPicture picture = shoot(room_, {"--layers", layers});
    EXPECT_GT(picture.covered(), 0.002) << layers;
    for (const auto& other : seen)
      EXPECT_NE(picture.pixels, other) << layers;
    seen.push_back(picture.pixels);
  }
}

TEST_F(ViewerOfMaps, ViewsDiffer)
{
  const auto from = [&](const std::string& place) {
    return shoot(room_, {"--layers", "texture", "--view", place});
  };
  const ShownPicture outside = from("outside");
  const ShownPicture inside = from("inside");
  const ShownPicture plan = from("plan");
  EXPECT_EQ(shoot(room_, {"--layers", "texture"}).pixels, outside.pixels);
  EXPECT_LT(plan.share(isRed), 0.004) << "the way, as the wall stands on its edge";
  EXPECT_GT(inside.share(isRed), 0.02);
  const auto is_cyan = [](const ShownPicture::Pixel& p) {
    return p[1] > 2 * p[0] && p[2] > 2 * p[0];
  };
  EXPECT_EQ(outside.share(is_cyan), 0);
  EXPECT_GT(inside.share(is_cyan), 0.05) << "only from inside there is a ceiling";
}

TEST_F(ViewerOfMaps, TellsWhatItFound)
{
  addMeshAndCloud();
  const ToolRun done = run(room_);
  for (const char* line : {"points:      400", "planes:      6"})
    EXPECT_NE(done.out.find(line), std::string::npos) << done.out;
}

TEST_F(ViewerOfMaps, TrajectoryOfAFileStandsInForThatOfTheMap)
{
  CompactMap map = makeRoomMap();
  saveCompactMap(room_, map);
  expectNoPicture(run(room_, {"--layers", "trajectory"}), 2, "trajectory");
  saveTrajectory(folder_.path("room/trajectory.txt"), makeRoomWay());
  EXPECT_EQ(run(room_, {"--layers", "trajectory"}).exit_code, 0);
}

TEST_F(ViewerOfMaps, ShowsWhatWasBeforeRectification)
{
  expectNoPicture(run(room_, {"--before"}), 2, "before");
  Trajectory before = makeRoomWay();
  for (Eigen::Isometry3d& pose : before.poses)
    pose.translation().z() += 1;
  saveTrajectory(folder_.path("room/trajectory_before.txt"), before);
  const ShownPicture after = shoot(room_, {"--layers", "trajectory"});
  EXPECT_NE(shoot(room_, {"--layers", "trajectory", "--before"}).pixels, after.pixels);
  expectNoPicture(run(room_, {"--layers", "planes", "--before"}), 2, "planes");
}

TEST_F(ViewerOfMaps, WarnsOfPosesBeforeThatDoNotFit)
{
  Trajectory before = makeRoomWay();
  before.poses.pop_back();
  before.stamps.pop_back();
  saveTrajectory(folder_.path("room/trajectory_before.txt"), before);
  const ToolRun done = run(room_);
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_NE(done.err.find("trajectory_before.txt has"), std::string::npos) << done.err;
  expectNoPicture(run(room_, {"--before"}), 2, "before");
  folder_.write("room/trajectory_before.txt", "0 0 0\n");
  expectNoPicture(run(room_), 3, "trajectory_before.txt");
}

TEST_F(ViewerOfMaps, ShowsFoldersOfARectificationAsAPlan)
{
  fs::create_directory(folder_.path("out"));
  std::string rows;
  for (int i = 0; i < 400; ++i)
    rows += std::to_string(i % 20 * 0.2) + " 1 " + std::to_string(i / 20 * 0.2) + " " +
            std::to_string(i % 4) + "\n";
  folder_.write("out/map.pcd",
                "VERSION 0.7\nFIELDS x y z view\nSIZE 4 4 4 4\nTYPE F F F I\n"
                "COUNT 1 1 1 1\nWIDTH 400\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
                "POINTS 400\nDATA ascii\n" +
                    rows);
  const std::string out = folder_.path("out");
  expectNoPicture(run(out), 3, "trajectory.txt");
  Trajectory way = makeRoomWay();
  way.poses.resize(3);
  way.stamps.resize(3);
  saveTrajectory(out + "/trajectory.txt", way);
  const ShownPicture plan = shoot(out);
  EXPECT_GT(plan.covered(), 0.01);
  EXPECT_EQ(shoot(out, {"--view", "plan"}).pixels, plan.pixels);
  EXPECT_NE(shoot(out, {"--view", "outside"}).pixels, plan.pixels);
  EXPECT_NE(shoot(out, {"--at", "1"}).pixels, plan.pixels);
  saveTrajectory(out + "/trajectory_before.txt", way);
  const ToolRun done = run(out, {"--before"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("100 points were seen from no pose"), std::string::npos)
      << done.err;
}

TEST_F(ViewerOfMaps, ShowsFoldersOfObservationsUnderTheirPoses)
{
  const std::string folder = folder_.path("observations");
  fs::create_directory(folder);
  for (const char* name : {"0", "1"})
    folder_.write(std::string("observations/observation_000") + name + ".pcd",
                  planePcd());
  const std::string first = "0 0 0 0 0 0 0 1\n";
  folder_.write("observations/trajectory.txt", first + "1 4 0 0 0 0 0 1\n");
  const ShownPicture apart = shoot(folder, {"--layers", "points"});
  folder_.write("observations/trajectory.txt", first + "1 0.01 0 0 0 0 0 1\n");
  const ShownPicture together = shoot(folder, {"--layers", "points"});
  EXPECT_NE(apart.pixels, together.pixels);
  folder_.write("observations/trajectory.txt", first);
  expectNoPicture(run(folder), 3, "trajectory.txt");
}

TEST_F(ViewerOfMaps, StepsThroughTheWallsOfAMesh)
{
  addMeshAndCloud();
  expectNoPicture(run(room_, {"--step", "0"}), 2, "wall depths");
  folder_.write("room/mesh.ply",
                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                "property float y\nproperty float z\nelement face 2\n"
                "property list uchar int vertex_indices\nproperty uchar wall_depth\n"
                "end_header\n0 1 0\n1 1 0\n0 1 1\n1 1 1\n3 0 1 2 0\n3 1 3 2 1\n");
  const ShownPicture first = shoot(room_, {"--step", "0"});
  EXPECT_GT(first.share(isRed), 0.001) << "the wall of depth 0";
  EXPECT_NE(shoot(room_, {"--step", "1"}).pixels, first.pixels);
  expectNoPicture(run(room_, {"--step", "2"}), 2, "step 2");
  expectNoPicture(run(room_, {"--step", "-1"}), 2, "--step");
}

TEST_F(ViewerOfMaps, RefusesOptionsThatMakeNoSense)
{
  expectNoPicture(run(room_, {"--at", "1000"}), 2, "1000");
  expectNoPicture(run(room_, {"--at", "0", "--view", "plan"}), 2, "--at");
  expectNoPicture(run(room_, {"--at", "x"}), 2, "--at");
  expectNoPicture(run(room_, {"--before", "--step", "0"}), 2, "--step");
  const std::string cloud = folder_.write("in.pcd", planePcd());
  expectNoPicture(run(room_, {"--layers", "planes,walls"}), 2, "walls");
  expectNoPicture(run(room_, {"--view", "below"}), 2, "below");
  expectNoPicture(run(room_, {"--layers", "mesh"}), 2, "mesh");
  expectNoPicture(run(cloud, {"--layers", "planes"}), 2, "planes");
  expectNoPicture(run(cloud, {"--view", "plan"}), 2, "plan");
  expectNoPicture(run(room_, {"--view", "plan", "--from", "0", "0", "0"}), 2, "--from");
  expectNoPicture(run(room_, {"--scale", "0.001"}), 2, "--scale");
  expectNoPicture(run(room_, {"--labels"}), 2, "label");
}

TEST_F(ViewerOfMaps, RefusesFoldersAndMapsThatAreNone)
{
  fs::create_directory(folder_.path("empty"));
  expectNoPicture(run(folder_.path("empty")), 3, "map.json");
  expectNoPicture(run(folder_.path("none")), 3, "none");
  expectNoPicture(run(folder_.path(std::string(300, 'x'))), 3, "xxx");
  expectNoPicture(run(std::string(5000, 'y')), 3, "yyy");
  expectNoPicture(run(folder_.write("bad.json", "{\"planes\":[")), 3, "bad.json");
  expectNoPicture(run(folder_.write("other.json", "{}")), 3, "other.json");
}

TEST_F(ViewerOfMaps, RefusesAnImageThatIsMissing)
{
  fs::remove(folder_.path("room/texture_0.png"));
  expectNoPicture(run(room_), 3, "texture_0.png");
  EXPECT_EQ(run(folder_.path("room/map.json")).exit_code, 0) << "needs no image";
}

TEST_F(ViewerOfMaps, RefusesAVersionItDoesNotKnow)
{
  edit("\"format\":" + std::to_string(file_formats::map), "\"format\":99");
  expectNoPicture(run(room_), 3, "99");
}

TEST_F(ViewerOfMaps, SaysWhenThereIsNoPlane)
{
  const std::string none = folder_.path("none.json");
  saveMapFile(none, {});
  expectNoPicture(run(none), 4, "no plane");
}

TEST_F(ViewerOfMaps, RefusesADamagedMeshBesideTheMap)
{
  folder_.write("room/mesh.ply", "ply\nformat ascii 1.0\n");
  expectNoPicture(run(room_), 3, "mesh.ply");
}

TEST_F(ViewerOfMaps, AsksForAnXServer)
{
  RunSettings blind;
  blind.environment = {{"DISPLAY", std::nullopt}};
  expectRefused(runViewer({room_, "--screenshot", picture_}, blind), 1, "xvfb-run");
  expectRefused(runViewer({room_}, blind), 1, "xvfb-run");
}

} // namespace
} // namespace pcl::acmap::test
