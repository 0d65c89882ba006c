#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/mesh_file.h>
#include <pcl/core/point_cloud_file.h>

#include <gtest/gtest.h>

#include <cstring>

namespace pcl::acmap::test {
namespace {

/** The planes of a noisy room, and their output files. */
class PlaneOutputs : public testing::Test {
protected:
  ToolRun
  run(const std::vector<std::string>& more = {}, const RunSettings& settings = {})
  {
    return runPlanes(joined({input_, json_}, more), settings);
  }

  nlohmann::json
  planes() const
  {
    return jsonOfFile(json_).at("planes");
  }

  TemporaryFolder folder_;
  std::string input_ = folder_.write("room.pcd", roomPcd());
  std::string json_ = folder_.path("p.json");
  std::string labels_ = folder_.path("labels.pcd");
  std::string normals_ = folder_.path("normals.ply");
};

double
distance(const nlohmann::json& plane, const nlohmann::json& point)
{
  return std::abs(coefficientsOf(plane).dot(pointOf(point).homogeneous()));
}

/** Area within a loop, positive if it is counter-clockwise seen along -normal. */
double
areaOf(const nlohmann::json& loop, const Eigen::Vector3d& normal)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += pointOf(loop[i]).cross(pointOf(loop[(i + 1) % loop.size()]));
  return sum.dot(normal) / 2;
}

TEST_F(PlaneOutputs, PolygonsLieOnTheirPlanesAndHaveTheirArea)
{
  run().succeeded();
  ASSERT_EQ(planes().size(), 5u);
  for (const auto& plane : planes()) {
    const Eigen::Vector3d normal = coefficientsOf(plane).head<3>();
    double area = 0;
    for (const auto& polygon : plane.at("polygons")) {
      std::vector<nlohmann::json> loops = {polygon.at("outer")};
      for (const auto& hole : polygon.at("holes"))
        loops.push_back(hole);
      EXPECT_GT(areaOf(loops[0], normal), 0);
      for (const auto& loop : loops) {
        EXPECT_GE(loop.size(), 3u);
        area += areaOf(loop, normal);
        for (const auto& point : loop)
          EXPECT_LT(distance(plane, point), 1e-6);
      }
    }
    EXPECT_NEAR(area, plane.at("area"), 1e-4);
  }
}

TEST_F(PlaneOutputs, TheCovarianceHasItsFrame)
{
  run().succeeded();
  std::size_t id = 0;
  for (const auto& plane : planes()) {
    EXPECT_EQ(plane.at("id"), id++);
    EXPECT_LT(distance(plane, plane.at("center")), 1e-9);
    Eigen::Matrix3d basis;
    basis << pointOf(plane.at("axes")[0]), pointOf(plane.at("axes")[1]),
        coefficientsOf(plane).head<3>();
    EXPECT_TRUE((basis.transpose() * basis).isIdentity(1e-9));
    EXPECT_NEAR(basis.determinant(), 1, 1e-9);
    for (int i = 0; i < 3; ++i)
      EXPECT_GT(plane.at("covariance")[i][i], 0);
    EXPECT_GT(plane.at("effective_support"), 10);
    EXPECT_NEAR(plane.at("rmse"), 0.006, 0.002);
  }
}

TEST_F(PlaneOutputs, NormalsStandInTheMesh)
{
  run({"--normals", normals_}).succeeded();
  const PointCloudFile mesh = loadPointCloud(normals_);
  EXPECT_GT(loadTriangleMesh(normals_).triangles.size(), 1000u);
  const auto labels = labelsOfFile(normals_);
  ASSERT_EQ(labels.size(), mesh.points().size());
  std::vector<std::size_t> offsets;
  for (const char* name : {"normal_x", "vertex_class"})
    for (const PCLPointField& field : mesh.cloud.fields)
      if (field.name == name)
        offsets.push_back(field.offset);
  ASSERT_EQ(offsets.size(), 2u);
  std::size_t surface = 0, right = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::uint8_t* const row = &mesh.cloud.data[i * mesh.cloud.point_step];
    if (row[offsets[1]] != 1 || labels[i] == 0)
      continue;
    Eigen::Vector3f normal;
    std::memcpy(normal.data(), row + offsets[0], sizeof(float) * 3);
    const auto plane = coefficientsOf(planes().at(labels[i] - 1));
    ++surface;
    right += normal.cast<double>().dot(plane.head<3>()) > 0.97 ? 1 : 0;
  }
  EXPECT_GT(surface, labels.size() * 3 / 4);
  EXPECT_GT(right, surface * 95 / 100);
}

/** Squares above each other, whose size increases with the height. */
std::string
stairsObj(int steps)
{
  constexpr int squares = 10;
  std::string points, faces;
  for (int step = 0, at = 1; step < steps; ++step)
    for (int i = 0; i <= squares; ++i)
      for (int k = 0; k <= squares; ++k, ++at) {
        const double size = (1 + 0.05 * step) / squares;
        points += "v " + std::to_string(i * size) + " " + std::to_string(k * size) +
                  " " + std::to_string(0.7 * step) + "\n";
        if (i < squares && k < squares)
          // the two triangles of a square
          for (const int other : {at + squares + 2, at + 1})
            faces +=
                "f " + std::to_string(at) + " " +
                std::to_string(other == at + 1 ? at + squares + 2 : at + squares + 1) +
                " " + std::to_string(other) + "\n";
      }
  return points + faces;
}

TEST_F(PlaneOutputs, OfManyPlanesTheLargestAreListed)
{
  const ToolRun many =
      runPlanes({folder_.write("many.obj", stairsObj(24)), json_}).succeeded();
  ASSERT_EQ(planes().size(), 24U);
  std::size_t listed = 0;
  for (std::size_t id = 0; id < 24; ++id) {
    const bool is_listed =
        many.out.find("plane " + std::to_string(id) + ":") != std::string::npos;
    listed += is_listed;
    EXPECT_EQ(is_listed, planes().at(id).at("area") > 3.7) << id;
  }
  EXPECT_EQ(listed, 5U) << many.out;
  EXPECT_NE(many.out.find("further planes: 19 smaller ones"), std::string::npos)
      << many.out;
  const ToolRun few = runPlanes({folder_.write("few.obj", stairsObj(3)), json_});
  EXPECT_NE(few.out.find("plane 2:"), std::string::npos) << few.out;
  EXPECT_EQ(few.out.find("further"), std::string::npos) << few.out;
}

TEST_F(PlaneOutputs, SummaryAndReportTellWhatWasDone)
{
  const std::string path = folder_.path("r.json");
  const ToolRun loud = run({"--labels", labels_, "--report", path}).succeeded();
  for (const char* word : {"consolidated:",
                           "planes:      5\n",
                           "on planes:",
                           "plane 4:",
                           " m2, rmse ",
                           "seconds:",
                           "p.json\n",
                           "labels.pcd\n"})
    EXPECT_NE(loud.out.find(word), std::string::npos) << word << "\n" << loud.out;
  const auto report = jsonOfFile(path);
  EXPECT_EQ(report.at("tool"), "pcl_plane_extraction");
  EXPECT_EQ(report.at("report").at("planes"), 5);
  EXPECT_EQ(report.at("input_points"), labelsOfFile(labels_).size());
  EXPECT_GT(report.at("mesh").at("triangles"), 1000);
  EXPECT_GT(report.at("votes").at("surface"), 500);
  for (const char* step :
       {"read", "consolidate", "triangulate", "votes", "planes", "write"})
    EXPECT_GE(report.at("seconds").at(step), 0.0) << step;
  const ToolRun quiet = run({"--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(PlaneOutputs, AFullDiskLeavesTheOldFilesAll)
{
  folder_.write("p.json", "old planes");
  RunSettings full;
  full.file_size_limit = 200000; // enough for the planes, but not for the labels
  expectRefused(run({"--labels", labels_}, full), 5, labels_);
  EXPECT_EQ(contentOf(json_), "old planes");
  EXPECT_EQ(folder_.count(), 2);
}

} // namespace
} // namespace pcl::acmap::test
