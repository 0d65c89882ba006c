#include "chain_runs.h"
#include "las_file.h"
#include "plane_runs.h"
#include "tool_cases.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/trajectory.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gmock/gmock.h>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string
observation(const std::string& folder, int number)
{
  return folder + "/observation_000" + std::to_string(number) + ".pcd";
}

/** \brief Writes poses as the files' VIEWPOINTs. */
void
setViewpoints(const std::string& folder, const Trajectory& poses)
{
  for (std::size_t i = 0; i < poses.poses.size(); ++i) {
    PointCloud<PointXYZRGB> cloud;
    const std::string path = observation(folder, static_cast<int>(i));
    ASSERT_EQ(io::loadPCDFile(path, cloud), 0);
    cloud.sensor_origin_.head<3>() = poses.poses[i].translation().cast<float>();
    cloud.sensor_orientation_ =
        Eigen::Quaternionf(poses.poses[i].linear().cast<float>());
    ASSERT_EQ(io::savePCDFileBinary(path, cloud), 0);
  }
}

class ChainInputs : public ChainTest {
protected:
  /** \brief The kind of input according to the report. */
  std::string
  start() const
  {
    return jsonOfFile(out_ + "/report.json").at("starting_point");
  }

  /** \brief Checks that an input is refused, and no files are left. */
  void
  refuse(const std::string& input,
         const std::vector<std::string>& options,
         int code,
         const std::string& word) const
  {
    expectRefused(runChain(input, out_, options), code, word);
    EXPECT_FALSE(fs::exists(out_)) << word;
  }

  std::string out_ = folder_.path("out");
};

TEST_F(ChainInputs, ObservationsWithoutPoses)
{
  runChain(observations(), out_).succeeded();
  EXPECT_EQ(start(), "observations");
  EXPECT_THAT(stagesOf(out_), ElementsAre("egomotion", "rectification", "map"));
  EXPECT_EQ(contentOf(out_ + "/map.json"), contentOf(map_ + "/map.json"));
}

TEST_F(ChainInputs, ObservationsWithATrajectory)
{
  runChain(posedObservations(), out_, {"--no-rectification"}).succeeded();
  EXPECT_EQ(start(), "posed observations");
  EXPECT_THAT(stagesOf(out_), ElementsAre("map"));
  const Trajectory taken = loadTrajectory(out_ + "/trajectory.txt");
  const Trajectory given = loadTrajectory(map_ + "/trajectory.txt");
  ASSERT_EQ(taken.poses.size(), given.poses.size());
  for (std::size_t i = 0; i < given.poses.size(); ++i)
    EXPECT_TRUE(taken.poses[i].isApprox(given.poses[i], 1e-12)) << i;
  EXPECT_EQ(jsonOfFile(out_ + "/report.json").at("planes"),
            jsonOfFile(map_ + "/report.json").at("planes"));
}

TEST_F(ChainInputs, ObservationsWithViewpoints)
{
  const std::string input = observations();
  setViewpoints(input, loadTrajectory(map_ + "/trajectory.txt"));
  runChain(input, out_).succeeded();
  EXPECT_EQ(start(), "posed observations");
  EXPECT_THAT(stagesOf(out_), ElementsAre("rectification", "map"));
  EXPECT_EQ(loadTrajectory(out_ + "/trajectory.txt").poses.size(), 3u);
}

TEST_F(ChainInputs, PosesThatAreAdjustedInSixDegreesOfFreedom)
{
  const std::string input = posedObservations();
  const Trajectory truth = loadTrajectory(input + "/trajectory.txt");
  Trajectory raised = truth;
  for (std::size_t i = 0; i < raised.poses.size(); ++i)
    raised.poses[i].translate(Eigen::Vector3d(0, 0.04 * static_cast<double>(i), 0));
  saveTrajectory(input + "/trajectory.txt", raised);
  const auto heightOfLast = [&](const std::vector<std::string>& options) {
    const ToolRun run = runChain(input, out_, options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const auto poses = loadTrajectory(out_ + "/trajectory.txt").poses;
    return poses.back().translation().y() - truth.poses.back().translation().y();
  };
  EXPECT_NEAR(heightOfLast({"--no-rectification"}), 0.08, 1e-6);
  EXPECT_NEAR(heightOfLast({"--no-rectification", "--6dof"}), 0, 0.03);
  EXPECT_THAT(stagesOf(out_), ElementsAre("adjustment", "map"));
  const auto details =
      jsonOfFile(out_ + "/report.json").at("stages").at(0).at("details");
  EXPECT_EQ(details.at("adjustment").at("outcome"), "adjusted");
  EXPECT_EQ(details.at("adjustment").at("moved").size(), truth.poses.size());
  EXPECT_NEAR(heightOfLast({"--6dof"}), 0, 0.03);
  EXPECT_THAT(stagesOf(out_), ElementsAre("rectification", "adjustment", "map"));
  heightOfLast({"--6dof"});
  EXPECT_THAT(madeStages(out_), IsEmpty());
  heightOfLast({"--6dof", "--odometry-noise", "0.02", "0.5"});
  EXPECT_THAT(madeStages(out_), ElementsAre("rectification", "adjustment", "map"));
}

/** A ground and a step of it, 30 m above the origin of a national grid. */
LasFile
survey()
{
  constexpr int columns = 100;
  LasFile las(2, 0, {500000, 4000000, 30}, columns * columns);
  for (std::size_t i = 0; i < las.points; ++i) {
    const auto column = static_cast<int>(i % columns),
               row = static_cast<int>(i / columns);
    const int millimetres[] = {100 * column, 100 * row, row < columns / 2 ? 0 : 3000};
    for (std::size_t axis = 0; axis < 3; ++axis)
      las.set<std::int32_t>(las.at(i) + 4 * axis, millimetres[axis]);
  }
  return las;
}

/** z of the normals of the planes of a map. */
std::vector<double>
risesOf(const std::string& map)
{
  std::vector<double> rises;
  const auto content = jsonOfFile(map + "/map.json");
  for (const auto& plane : content.at("planes"))
    rises.push_back(plane.at("coefficients").at(2).get<double>());
  return rises;
}

TEST_F(ChainInputs, GroundOfASurveyFacesUp)
{
  const LasFile las = survey();
  const std::string path = folder_.write("survey.las", las.bytes);
  refuse(path, {"--bin", "0.1"}, 2, "--bin: is for observations");
  ToolRun run = runChain(path, out_);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(risesOf(out_), ElementsAre(DoubleNear(1, 1e-6), DoubleNear(1, 1e-6)));
  EXPECT_EQ(jsonOfFile(out_ + "/map.json").at("up"),
            nlohmann::json::array({0.0, 0.0, 1.0}));

  const std::string pcd = folder_.path("survey.pcd");
  savePointCloud(pcd, loadPointCloud(path).cloud);
  run = runChain(pcd, out_, {"--up", "z"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(risesOf(out_), ElementsAre(DoubleNear(1, 1e-6), DoubleNear(1, 1e-6)));
  run = runChain(pcd, out_);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(risesOf(out_), ElementsAre(DoubleNear(-1, 1e-6), DoubleNear(-1, 1e-6)))
      << "without a sensor and up direction, the origin is the sensor";
}

TEST_F(ChainInputs, OneObservationAloneIsPosed)
{
  const std::string input = observations();
  fs::remove(observation(input, 1));
  fs::remove(observation(input, 2));
  runChain(input, out_).succeeded();
  EXPECT_THAT(stagesOf(out_), ElementsAre("map"));
  EXPECT_EQ(jsonOfFile(out_ + "/report.json").at("observations"), 1);
  EXPECT_FALSE(fs::exists(out_ + "/trajectory_before.txt"));
}

TEST_F(ChainInputs, OneCloud)
{
  runChain(map_ + "/map.pcd", out_).succeeded();
  EXPECT_EQ(start(), "cloud");
  EXPECT_THAT(stagesOf(out_), ElementsAre("map"));
  EXPECT_FALSE(fs::exists(out_ + "/trajectory.txt"));
  EXPECT_EQ(runChain(map_ + "/map.pcd", out_).exit_code, 0);
  EXPECT_TRUE(madeStages(out_).empty());
}

TEST_F(ChainInputs, ASessionWithKnownPosesNeedsNoEgomotion)
{
  const std::string poses = session_ + "/trajectory.txt";
  runSessionChain(session_, out_, {"--poses", poses, "--no-rectification"}).succeeded();
  EXPECT_THAT(stagesOf(out_), ElementsAre("observations", "map"));
  const Trajectory truth = loadTrajectory(poses);
  const Trajectory taken = loadTrajectory(out_ + "/trajectory.txt");
  ASSERT_EQ(taken.poses.size(), truth.poses.size());
  for (std::size_t i = 0; i < taken.poses.size(); ++i)
    EXPECT_LT((taken.poses[i].matrix() - truth.poses[i].matrix()).norm(), 1e-6) << i;
}

TEST_F(ChainInputs, OptionsOfStagesOnNoWayAreRefused)
{
  const std::string cloud = map_ + "/map.pcd";
  const std::string unposed = map_ + "/stages/observations";
  refuse(unposed, {"--min-depth", "1"}, 2, "--min-depth: is for raw sessions");
  refuse(unposed, {"--poses", session_ + "/trajectory.txt"}, 2, "--poses: is for raw");
  refuse(cloud, {"--keypoints", "500"}, 2, "--keypoints: is for observations without");
  refuse(cloud, {"--bin", "0.1"}, 2, "--bin: is for observations");
  refuse(cloud, {"--no-rectification"}, 2, "--no-rectification: is for observations");
  refuse(cloud, {"--6dof"}, 2, "--6dof: is for observations");
  refuse(cloud, {"--truth", session_}, 2, "--truth is for observations");
  refuse(posedObservations(), {"--keypoints", "500"}, 2, "posed observations");
  refuse(session_, {"--scale", "0.001"}, 2, "--scale is for point clouds");
  refuse(session_,
         {"--poses", session_ + "/trajectory.txt", "--keypoints", "500"},
         2,
         "--keypoints: is not used");
  refuse(session_, {"--min-depth", "5", "--max-depth", "2"}, 2, "--min-depth");
  refuse(cloud, {"--max-points", "999"}, 2, "--max-points");
}

TEST_F(ChainInputs, WhatIsReadMustNotLieWhereTheMapGoes)
{
  const auto before = resultsIn(map_);
  const std::string word = "lies in the folder that is to hold the map";
  for (const char* name : {"", "/map.pcd", "/stages/observations", "/stages/../"})
    expectRefused(runChain(map_ + name, map_), 2, word);
  expectRefused(
      runAgain({"--poses", map_ + "/trajectory.txt"}), 2, "trajectory.txt: " + word);
  fs::create_directory_symlink(map_, folder_.path("link"));
  expectRefused(runChain(map_ + "/map.pcd", folder_.path("link")), 2, word);
  EXPECT_THAT(differing(resultsIn(map_), before), IsEmpty());
}

TEST_F(ChainInputs, InputsOfNoUseLeaveNothing)
{
  const std::string empty = folder_.path("empty");
  fs::create_directory(empty);
  refuse(empty, {}, 3, "holds no .pcd");
  refuse(folder_.path("none"), {}, 3, "none");
  refuse(folder_.write("broken.pcd", "VERSION"), {}, 3, "broken.pcd");
  std::ofstream(empty + "/session.yaml") << "garbage";
  refuse(empty, {}, 3, "session.yaml");
  refuse(session_, {"--truth", empty}, 3, "truth.json");
  refuse(session_, {"--poses", folder_.path("none")}, 3, "none");
  refuse(posedObservations(),
         {"--no-rectification", "--min-area", "1000", "--no-primitives"},
         4,
         "plane");
}

/** A map that cannot be made leaves the one before, with its stages. */
TEST_F(ChainInputs, AStageThatFailsKeepsThoseBefore)
{
  // where no plane may be found, a bit of a wall may be told to be a cylinder
  const auto refused = [&] {
    return runAgain({"--min-area", "1000", "--no-primitives"});
  };
  expectRefused(refused(), 4, "plane");
  EXPECT_EQ(runAgain().exit_code, 0);
  EXPECT_THAT(madeStages(map_), IsEmpty());
}

TEST_F(ChainInputs, BrokenObservationsAreSkippedOnRequest)
{
  const std::string input = observations();
  setViewpoints(input, loadTrajectory(map_ + "/trajectory.txt"));
  std::ofstream(observation(input, 0)) << "VERSION";
  refuse(input, {}, 3, "observation_0000.pcd");
  const ToolRun run = runChain(input, out_, {"--skip-broken"}).succeeded();
  EXPECT_EQ(start(), "posed observations");
  EXPECT_THAT(run.err, HasSubstr("observation_0000.pcd"));
  EXPECT_EQ(jsonOfFile(out_ + "/report.json").at("observations"), 2);
  EXPECT_EQ(loadTrajectory(out_ + "/trajectory.txt").poses.size(), 2u);
}

TEST_F(ChainTest, ExtendsAMapThatHasSeenTheSamePlace)
{
  const std::string out = folder_.path("extended");
  const ToolRun run = runSessionChain(session_, out, {"--extend", map_}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("places that both maps have seen"));
  EXPECT_THAT(
      stagesOf(out),
      ElementsAre("observations", "egomotion", "extension", "rectification", "map"));
  const ToolRun again = runSessionChain(session_, out, {"--extend", map_});
  EXPECT_THAT(madeStages(out), IsEmpty()) << again.err;
  EXPECT_EQ(runSessionChain(session_, map_, {"--extend", map_}).exit_code, 2);
  fs::remove(map_ + "/stages/observations.txt");
  const ToolRun without =
      runSessionChain(session_, folder_.path("other"), {"--extend", map_});
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_THAT(without.err, HasSubstr("observations.txt: is missing"));
}

} // namespace
} // namespace pcl::acmap::test
