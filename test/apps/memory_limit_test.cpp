#include "las_file.h"
#include "sanitized.h"
#include "small_session.h"
#include "temporary_folder.h"
#include "tool_cases.h"
#include "virtual_display.h"

#include <pcl/conversions.h>
#include <pcl/core/image_file.h>
#include <pcl/core/point_cloud_writer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;

/** A session, its observations with poses, a photograph and planes, made once. */
class MemoryLimit : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    folder_ = new TemporaryFolder;
    filmSmallSession(path("session"));
    runTool(ACMAP_SIMULATED_RIG,
            {"-o",
             path("clouds"),
             "--scene",
             "corridor_drive",
             "--observations",
             "2",
             "--clouds"})
        .succeeded();
    RgbImage photograph{1000, 800, {}};
    photograph.values.assign(std::size_t{3} * 1000 * 800, 90);
    for (int number = 0; number < 6; ++number)
      savePng(path("photograph_" + std::to_string(number) + ".png"), photograph);
    fs::create_directory(path("rgbd"));
    savePng(path("rgbd/frame-000000.color.png"), photograph);
    savePng(path("rgbd/frame-000000.depth.png"), photograph);
    folder_->write("planes.json",
                   R"({"planes":[{"id":0,"coefficients":[0,0,-1,3],"center":[0,0,3],)"
                   R"("axes":[[1,0,0],[0,1,0]],"covariance":[[1,0,0],[0,1,0],[0,0,1]],)"
                   R"("support":9,"effective_support":9,"rmse":0.01,"area":1,)"
                   R"("polygons":[{"outer":[[0,0,3],[1,0,3],[1,1,3]],"holes":[]}]}]})");
  }

  static void
  TearDownTestSuite()
  {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string
  path(const std::string& name)
  {
    return folder_->path(name);
  }

  static std::string
  cloud()
  {
    return path("clouds/observation_0000.pcd");
  }

  void
  TearDown() override
  {
    fs::remove_all(path("out"));
  }

  /** Runs a tool whose output is `out`, or begins with it. */
  static ToolRun
  run(const std::string& tool, std::vector<std::string> arguments, const char* limit)
  {
    arguments.insert(arguments.end(), {"--memory-limit", limit});
    return runTool(tool, arguments);
  }

  static TemporaryFolder* folder_;
};

TemporaryFolder* MemoryLimit::folder_ = nullptr;

TEST_F(MemoryLimit, EndsEachToolWithNothingLeftBehind)
{
  if (is_sanitized)
    GTEST_SKIP() << "a sanitizer ends the process where memory is refused";
  VirtualDisplay::shared(); // for the viewer
  const std::string out = path("out");
  const std::vector<std::pair<std::string, std::vector<std::string>>> runs = {
      {ACMAP_DEWALL_SURFACE, {cloud(), out + ".ply"}},
      {ACMAP_PLANE_EXTRACTION, {cloud(), out + ".json"}},
      {ACMAP_COMPACT_VIEWER, {cloud(), "--screenshot", out + ".png"}},
      {ACMAP_SIMULATED_RIG, {"-o", out, "--scene", "corridor_drive"}},
      {ACMAP_SIMULATED_RIG, {"-o", out, "--scene", "corridor_drive", "--clouds"}},
      {ACMAP_ACTIVE_STEREO, {path("session"), "-o", out}},
      {ACMAP_CAMERA_GRABBER, {"--device", path("session"), "-o", out}},
      {ACMAP_DIGICLOPS_GRABBER, {"--device", path("session"), "-o", out}},
      {ACMAP_DIGICLOPS_GRABBER, {"--device", path("session"), "--pcd", out}},
      {ACMAP_VISUAL_EGOMOTION, {path("clouds"), "-o", out}},
      {ACMAP_ENTROPY_RECTIFICATION, {path("clouds"), "-o", out}},
      {ACMAP_PLANE_TEXTURING, {path("planes.json"), path("clouds"), "-o", out}},
      {ACMAP_COMPACT_MAPPING, {path("session"), "-o", out}},
      {ACMAP_COMPACT_MAPPING, {cloud(), "-o", out}},
      {ACMAP_LINE_PATTERN, {out + ".png"}},
      {ACMAP_RGBD_IMPORT, {path("rgbd"), "-o", out, "--no-poses"}},
      {ACMAP_RIG_CALIBRATION,
       {"--square",
        "0.03",
        "-o",
        out + ".yaml",
        "--reference",
        path("photograph_0.png"),
        path("photograph_1.png"),
        path("photograph_2.png"),
        "--horizontal",
        path("photograph_3.png"),
        path("photograph_4.png"),
        path("photograph_5.png")}}};
  const auto before = folder_->count();
  for (const auto& [tool, arguments] : runs) {
    SCOPED_TRACE(tool + " " + arguments.front());
    expectRefused(run(tool, arguments, "100KB"), 6, "--memory-limit");
    EXPECT_EQ(folder_->count(), before);
  }
}

TEST_F(MemoryLimit, RoomyChangesNothing)
{
  runSurface({cloud(), path("without.ply")}).succeeded();
  run(ACMAP_DEWALL_SURFACE, {cloud(), path("with.ply")}, "6GB").succeeded();
  EXPECT_TRUE(contentOf(path("with.ply")) == contentOf(path("without.ply")));
  fs::remove(path("with.ply"));
  fs::remove(path("without.ply"));
}

/** A wall of 490,000 points with noise. */
PointCloud<PointXYZ>
noisyWall()
{
  PointCloud<PointXYZ> wall;
  std::uint32_t bits = 1;
  const auto noise = [&bits] {
    bits = bits * 1664525u + 1013904223u;
    return static_cast<float>(bits >> 8) / (1 << 24) - 0.5F;
  };
  for (int row = 0; row < 700; ++row)
    for (int column = 0; column < 700; ++column)
      wall.emplace_back(0.01F * (static_cast<float>(column) + noise()),
                        0.01F * (static_cast<float>(row) + noise()),
                        2 + 0.01F * noise());
  return wall;
}

/** Meshing takes 170 bytes for each point in memory: here they are in files. */
class MeshOfManyPoints : public MemoryLimit {
protected:
  void
  SetUp() override
  {
    if (is_sanitized)
      GTEST_SKIP() << "a sanitizer has memory of its own";
  }

  static void
  expectKeepsTheLimit(const std::string& cloud)
  {
    runSurface({cloud, path("without.ply")}).succeeded();
    const auto before = folder_->count();
    run(ACMAP_DEWALL_SURFACE, {cloud, path("with.ply")}, "50MB").succeeded();
    EXPECT_EQ(folder_->count(), before + 1) << "no file but the mesh is left";
    EXPECT_TRUE(contentOf(path("with.ply")) == contentOf(path("without.ply")));
    for (const std::string& file : {cloud, path("with.ply"), path("without.ply")})
      fs::remove(file);
  }
};

TEST_F(MeshOfManyPoints, KeepsTheLimit)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(noisyWall(), cloud);
  savePointCloud(path("wall.pcd"), cloud);
  expectKeepsTheLimit(path("wall.pcd"));
}

TEST_F(MeshOfManyPoints, OfAScanKeepsTheLimit)
{
  const PointCloud<PointXYZ> wall = noisyWall();
  LasFile las(2, 3, {200000, 5000000, 100}, static_cast<std::uint32_t>(wall.size()));
  for (std::size_t i = 0; i < wall.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      las.set(las.at(i) + 4 * axis,
              static_cast<std::int32_t>(std::lround(
                  wall[i].getVector3fMap()[static_cast<Eigen::Index>(axis)] /
                  LasFile::scale)));
  expectKeepsTheLimit(folder_->write("wall.las", las.bytes));
}

TEST_F(MemoryLimit, MeetsWorkersOnTheWayWithoutHarm)
{
  if (is_sanitized)
    GTEST_SKIP() << "a sanitizer ends the process where memory is refused";
  std::size_t done = 0;
  for (const char* limit : {"3MB", "12MB", "25MB", "50MB", "75MB", "100MB", "3GB"}) {
    const std::string clouds = path("out");
    const ToolRun stereo = run(
        ACMAP_ACTIVE_STEREO, {path("session"), "-o", clouds, "--threads", "8"}, limit);
    SCOPED_TRACE(limit);
    if (stereo.exit_code == 0)
      ++done;
    else
      expectRefused(stereo, 6, "--memory-limit");
    EXPECT_EQ(fs::exists(clouds), stereo.exit_code == 0);
    fs::remove_all(clouds);
  }
  EXPECT_GE(done, 1U);
}

TEST_F(MemoryLimit, NonsenseIsRefused)
{
  for (const char* size : {"much", "-5MB", "0", "", "1.5GB", "99999999999GB", "5 fish"})
    expectRefused(
        run(ACMAP_DEWALL_SURFACE, {cloud(), path("out.ply")}, size), 2, "--help");
}

} // namespace
} // namespace pcl::acmap::test
