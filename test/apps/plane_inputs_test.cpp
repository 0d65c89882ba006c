#include "clouds.h"
#include "plane_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcl::acmap::test {
namespace {

class PlaneInputs : public testing::Test {
protected:
  /** Runs the tool, which also writes the labels, and returns the planes. */
  nlohmann::json
  planesOf(const std::string& input, std::vector<std::string> more = {})
  {
    std::vector<std::string> arguments =
        joined({input, json_, "--labels", labels_, "--report", report_}, more);
    run_ = runPlanes(arguments);
    EXPECT_EQ(run_.exit_code, 0) << run_.err;
    return run_.exit_code == 0 ? jsonOfFile(json_).at("planes") : nlohmann::json();
  }

  bool
  hasConsolidated() const
  {
    return jsonOfFile(report_).contains("consolidation");
  }

  TemporaryFolder folder_;
  std::string json_ = folder_.path("p.json");
  std::string labels_ = folder_.path("labels.pcd");
  std::string report_ = folder_.path("r.json");
  ToolRun run_;
};

TEST_F(PlaneInputs, ACloudIsConsolidatedAutomaticallyOrAsTold)
{
  const std::string room = folder_.write("room.pcd", roomPcd());
  const auto voxelOf = [&](const std::vector<std::string>& more) {
    EXPECT_EQ(planesOf(room, more).size(), 5u);
    return jsonOfFile(report_).at("consolidation").at("voxel_size").get<double>();
  };
  const double automatic = voxelOf({});
  EXPECT_GT(automatic, 0.02);
  EXPECT_EQ(voxelOf({"--consolidate"}), automatic);
  EXPECT_EQ(voxelOf({"-consolidate", "auto"}), automatic);
  EXPECT_EQ(voxelOf({"--consolidate=0.15"}), 0.15);
}

TEST_F(PlaneInputs, ACloudWithoutNoiseIsMeshedAsItIs)
{
  const Cloud room = makeRoom(0.05, 0, 1);
  const std::string exact = folder_.write("exact.pcd", pcdText(room));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{}, std::vector<std::string>{"--paper"}}) {
    const auto planes = planesOf(exact, more);
    EXPECT_FALSE(hasConsolidated());
    EXPECT_NE(run_.out.find("consolidated: no"), std::string::npos) << run_.out;
    const bool is_paper = !more.empty(); // with planes of at most 1.6 m
    EXPECT_TRUE(is_paper ? planes.size() > 5 : planes.size() == 5) << planes.size();
    for (const Eigen::Vector4d& truth : roomPlanes())
      EXPECT_FALSE(matchOf(planes, truth, 0.01, 1e-4).is_null());
    const auto labels = labelsOfFile(labels_);
    ASSERT_EQ(labels.size(), room.size());
    const auto left = std::count(labels.begin(), labels.end(), 0U);
    EXPECT_LE(left, is_paper ? static_cast<std::ptrdiff_t>(room.size() / 10) : 0);
  }
  EXPECT_EQ(planesOf(exact, {"--consolidate", "auto"}).size(), 5U);
  EXPECT_TRUE(hasConsolidated());
}

TEST_F(PlaneInputs, ToleranceJoinsWhatItIsToldTo)
{
  std::string rows;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 40; ++j)
      rows += std::to_string(0.05 * i) + " " + std::to_string(0.05 * j) + " " +
              (i < 30 ? "1\n" : "1.03\n");
  const std::string step = folder_.write("step.xyz", rows);
  EXPECT_EQ(planesOf(step).size(), 2U);
  EXPECT_EQ(planesOf(step, {"--tolerance", "0.1"}).size(), 1U);
  expectRefused(runPlanes({step, json_, "--tolerance", "0"}), 2, "--tolerance");
  expectRefused(runPlanes({step, json_, "--tolerance", "1", "--paper"}), 2, "--paper");
}

TEST_F(PlaneInputs, EveryFormatGivesTheRoom)
{
  const Cloud room = makeRoom(0.03, 0.2, 1);
  std::string xyz, obj,
      ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(room.size()) +
            "\nproperty float x\nproperty float y\nproperty float "
            "z\nend_header\n";
  for (const PointXYZ& p : room) {
    const std::string row =
        std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
    xyz += row + "\n";
    obj += "v " + row + "\n";
    ply += row + "\n";
  }
  for (const std::string& input : {folder_.write("room.xyz", xyz),
                                   folder_.write("room.obj", obj),
                                   folder_.write("room.ply", ply)}) {
    const auto planes = planesOf(input);
    EXPECT_TRUE(hasConsolidated());
    for (const Eigen::Vector4d& truth : roomPlanes())
      EXPECT_FALSE(matchOf(planes, truth, 0.1, 0.001).is_null()) << input;
    EXPECT_EQ(labelsOfFile(labels_).size(), room.size());
  }
}

TEST_F(PlaneInputs, FacesMakeAMesh)
{
  const auto planes = planesOf(folder_.write("cube.obj", cubeObj()));
  EXPECT_FALSE(hasConsolidated());
  ASSERT_EQ(planes.size(), 6u);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Eigen::Vector4d truth(0, 0, 0, -0.5);
      truth[axis] = sign;
      const auto found = matchOf(planes, truth, 0.01, 1e-6);
      ASSERT_FALSE(found.is_null());
      EXPECT_NEAR(found.at("area"), 1.0, 0.02);
    }
  const auto labels = labelsOfFile(labels_);
  EXPECT_EQ(labels.size(), 6u * 21 * 21);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0u), 0);
}

TEST_F(PlaneInputs, PropertiesThatNoPcdHoldsAreLeftOut)
{
  std::string rows, faces;
  for (int i = 0; i < 400; ++i)
    rows += std::to_string(0.05 * (i % 20)) + " " + std::to_string(0.05 * (i / 20)) +
            " 2 1 2 3\n";
  for (int i = 0; i < 380; ++i)
    if (i % 20 < 19)
      faces += "4 " + std::to_string(i) + " " + std::to_string(i + 20) + " " +
               std::to_string(i + 21) + " " + std::to_string(i + 1) + "\n";
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float "
      "y\nproperty float z\nproperty float heat\nproperty float heat\nproperty uchar "
      "label\nelement face 361\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(planesOf(folder_.write("in.ply", header + rows + faces)).size(), 1u);
  EXPECT_EQ(labelsOfFile(labels_), std::vector<std::uint32_t>(400, 1));
}

TEST_F(PlaneInputs, ConsolidateDropsTheFaces)
{
  planesOf(folder_.write("cube.obj", cubeObj()), {"--consolidate", "0.1"});
  EXPECT_TRUE(hasConsolidated());
  EXPECT_EQ(labelsOfFile(labels_).size(), 6u * 21 * 21);
}

TEST_F(PlaneInputs, SmallPlanesAreLeftOutAsTold)
{
  const std::string cube = folder_.write("cube.obj", cubeObj());
  expectRefused(runPlanes({cube, json_, "--min-area", "1.5"}), 4, "no plane was found");
  EXPECT_EQ(planesOf(cube, {"-min_area", "0.5"}).size(), 6u);
}

TEST_F(PlaneInputs, ScaleMakesMetres)
{
  const std::string cube = folder_.write("cube.obj", cubeObj());
  const auto planes = planesOf(cube, {"--scale", "2"});
  ASSERT_EQ(planes.size(), 6u);
  for (const auto& plane : planes)
    EXPECT_NEAR(plane.at("area"), 4.0, 0.1);
}

TEST_F(PlaneInputs, CurvedSurfacesAreNoPlanes)
{
  SheetSampling sampling;
  sampling.columns = sampling.rows = 90;
  sampling.spacing = 0.01;
  const std::string ball =
      folder_.write("ball.pcd", pcdText(makeSphereCap(sampling, 1).cloud));
  expectRefused(runPlanes({ball, json_}), 4, "no plane was found");
}

TEST_F(PlaneInputs, ViewsWithoutATrajectoryAreTold)
{
  std::string rows;
  const Cloud room = makeRoom(0.03, 0.2, 1);
  for (const PointXYZ& p : room)
    rows += std::to_string(p.x) + " " + std::to_string(p.y) + " " +
            std::to_string(p.z) + " 0\n";
  const std::string size = std::to_string(room.size());
  const std::string map = folder_.write(
      "map.pcd",
      "VERSION 0.7\nFIELDS x y z view\nSIZE 4 4 4 4\nTYPE F F F I\nWIDTH " + size +
          "\nHEIGHT 1\nPOINTS " + size + "\nDATA ascii\n" + rows);
  EXPECT_EQ(planesOf(map).size(), 5u);
  EXPECT_NE(run_.err.find("trajectory.txt"), std::string::npos) << run_.err;
  folder_.write("trajectory.txt", "0 0 0 0 0 0 0 1\n");
  EXPECT_EQ(planesOf(map).size(), 5u);
  EXPECT_EQ(run_.err.find("trajectory.txt"), std::string::npos) << run_.err;
}

/** Two floors without noise, one above the other: the second was seen from below. */
TEST_F(PlaneInputs, PlanesOfACloudMeshedAsItIsLookToTheirViews)
{
  std::string rows;
  for (const int view : {0, 1})
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j)
        rows += std::to_string(0.05 * i) + " " + std::to_string(0.05 * j) + " " +
                std::to_string(4 + 4 * view) + " " + std::to_string(view) + "\n";
  const std::string map =
      folder_.write("map.pcd",
                    "VERSION 0.7\nFIELDS x y z view\nSIZE 4 4 4 4\nTYPE F F F I\nWIDTH "
                    "3200\nHEIGHT 1\nPOINTS 3200\nDATA ascii\n" +
                        rows);
  folder_.write("trajectory.txt", "0 1 1 6 0 0 0 1\n1 1 1 6 0 0 0 1\n");
  const auto planes = planesOf(map);
  EXPECT_FALSE(hasConsolidated());
  ASSERT_EQ(planes.size(), 2u);
  for (const auto& plane : planes) {
    const double height = pointOf(plane.at("center")).z();
    EXPECT_NEAR(coefficientsOf(plane)[2], height < 6 ? 1 : -1, 1e-6) << height;
  }
}

} // namespace
} // namespace pcl::acmap::test
