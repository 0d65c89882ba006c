#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl::acmap::test {
namespace {

/** Four views of the simulated corridor, merged, and their planes. */
class PlaneCorridor : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    folder_ = std::make_unique<TemporaryFolder>();
    runTool(ACMAP_SIMULATED_RIG,
            {"-o",
             path("session"),
             "--clouds",
             "--observations",
             "4",
             "--merged",
             path("map.pcd")})
        .succeeded();
    // the views are known from the trajectory next to the cloud
    std::filesystem::rename(path("map.pcd"), path("session/map.pcd"));
    run_ = runPlanes(
        {path("session/map.pcd"), path("p.json"), "--labels", path("labels.pcd")});
    ASSERT_EQ(run_.exit_code, 0) << run_.err;
  }

  static void
  TearDownTestSuite()
  {
    folder_.reset();
  }

  static std::string
  path(const std::string& name)
  {
    return folder_->path(name);
  }

  static nlohmann::json
  truthOf(const std::string& name)
  {
    const auto truth = jsonOfFile(path("session/truth.json"));
    for (const auto& plane : truth.at("planes"))
      if (plane.at("name") == name)
        return plane;
    return {};
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline ToolRun run_;
};

TEST_F(PlaneCorridor, WallsFloorAndCeilingAreWhereTheyAre)
{
  EXPECT_EQ(run_.err.find("sensors"), std::string::npos) << run_.err;
  const auto planes = jsonOfFile(path("p.json")).at("planes");
  for (const char* name : {"right wall", "left wall", "floor", "ceiling", "near end"}) {
    const Eigen::Vector4d truth = coefficientsOf(truthOf(name));
    const auto found = matchOf(planes, truth, 0.1, 0.001);
    ASSERT_FALSE(found.is_null()) << name;
    EXPECT_GT(found.at("area"), 4.0) << name;
    EXPECT_GT(found.at("support"), 20000) << name;
  }
  const auto doors = coefficientsOf(truthOf("doors left"));
  EXPECT_FALSE(matchOf(planes, doors, 0.2, 0.002).is_null());
}

TEST_F(PlaneCorridor, LabelsAreTheTruthsAndThePointsStay)
{
  const PointCloudFile input = loadPointCloud(path("session/map.pcd"));
  const PointCloudFile output = loadPointCloud(path("labels.pcd"));
  ASSERT_EQ(output.points().size(), input.points().size());
  ASSERT_EQ(output.cloud.fields.size(), input.cloud.fields.size());
  for (std::size_t i = 0; i < input.points().size(); ++i)
    ASSERT_EQ(output.points()[i], input.points()[i]) << i;

  const auto planes = jsonOfFile(path("p.json")).at("planes");
  const auto found = labelsOfFile(path("labels.pcd"));
  const auto truth = labelsOfFile(path("session/map.pcd"));
  std::vector<std::size_t> points(planes.size() + 1, 0);
  for (const std::uint32_t label : found)
    ++points.at(label);
  EXPECT_LT(points[0], found.size() / 50);
  for (const char* name : {"right wall", "left wall", "floor", "ceiling"}) {
    const auto plane = truthOf(name);
    const auto match = matchOf(planes, coefficientsOf(plane), 0.1, 0.001);
    ASSERT_FALSE(match.is_null());
    const auto its_label = match.at("id").get<std::uint32_t>() + 1;
    const auto true_label = plane.at("id").get<std::uint32_t>() + 1;
    std::size_t both = 0, either = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      both += found[i] == its_label && truth[i] == true_label ? 1 : 0;
      either += found[i] == its_label || truth[i] == true_label ? 1 : 0;
    }
    EXPECT_GT(static_cast<double>(both), 0.97 * static_cast<double>(either)) << name;
  }
}

TEST_F(PlaneCorridor, TheMeshAloneDoesToo)
{
  const std::string mesh = path("mesh.ply");
  runSurface({path("session/map.pcd"), mesh, "--consolidate"}).succeeded();
  runPlanes(
      {mesh, path("m.json"), "--labels", path("m.pcd"), "--report", path("r.json")})
      .succeeded();
  EXPECT_EQ(labelsOfFile(path("m.pcd")).size(), loadPointCloud(mesh).points().size());
  EXPECT_FALSE(jsonOfFile(path("r.json")).contains("consolidation"));
  const auto planes = jsonOfFile(path("m.json")).at("planes");
  for (const char* name : {"right wall", "left wall", "floor", "ceiling", "near end"})
    EXPECT_FALSE(matchOf(planes, coefficientsOf(truthOf(name)), 0.1, 0.001).is_null())
        << name;
}

TEST_F(PlaneCorridor, ThePapersThresholdsFindWholeWallsAndSwallowTheDoors)
{
  // each 16th raw point, next to the trajectory that knows the views
  const std::string thin = path("session/thin.pcd");
  const PCLPointCloud2 all = loadPointCloud(path("session/map.pcd")).cloud;
  PCLPointCloud2 some = all;
  some.data.clear();
  for (std::size_t at = 0; at < all.data.size(); at += 16 * std::size_t{all.point_step})
    some.data.insert(some.data.end(), &all.data[at], &all.data[at] + all.point_step);
  some.width = static_cast<std::uint32_t>(some.data.size() / some.point_step);
  some.height = 1;
  some.row_step = static_cast<std::uint32_t>(some.data.size());
  savePointCloud(thin, some);

  const ToolRun run = runPlanes({thin,
                                 path("paper.json"),
                                 "--paper",
                                 "--labels",
                                 path("paper.pcd"),
                                 "--report",
                                 path("paper_report.json")})
                          .succeeded();
  EXPECT_NE(run.out.find("consolidated: no, the paper takes raw points"),
            std::string::npos)
      << run.out;
  const auto report = jsonOfFile(path("paper_report.json"));
  EXPECT_EQ(report.at("mode"), "paper");
  EXPECT_EQ(report.at("consolidated_points"), 0);
  EXPECT_GT(report.at("mesh").at("walls"), 0);
  const auto planes = jsonOfFile(path("paper.json")).at("planes");
  // of the floor, each 16th point is too sparse for a mesh
  for (const char* name : {"right wall", "left wall", "ceiling"}) {
    const Eigen::Vector4d truth = coefficientsOf(truthOf(name));
    double largest = 0; // of a piece within W_d of one hypothesis: pi W_d^2 at most
    for (const auto& plane : planes) {
      const Eigen::Vector4d piece = coefficientsOf(plane);
      if (angleBetween(piece, truth) < 5 && std::abs(piece[3] - truth[3]) < 0.3)
        largest = std::max(largest, plane.at("area").get<double>());
    }
    EXPECT_GT(largest, 2 * M_PI * 0.8 * 0.8) << name;
  }
  EXPECT_TRUE(
      matchOf(planes, coefficientsOf(truthOf("doors left")), 1, 0.01).is_null());
  EXPECT_EQ(labelsOfFile(path("paper.pcd")).size(), some.width);
}

} // namespace
} // namespace pcl::acmap::test
