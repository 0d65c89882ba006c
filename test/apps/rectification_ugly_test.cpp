#include "json_file.h"
#include "rectification_runs.h"
#include "temporary_folder.h"
#include "tool_cases.h"

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_cloud_writer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RectificationFaults : public testing::Test {
protected:
  void
  refuse(std::vector<std::string> input, int code, const std::string& word) const
  {
    input.insert(input.end(), {"-o", folder_.path("out")});
    expectRefused(runRectification(input), code, word);
    EXPECT_FALSE(fs::exists(folder_.path("out")));
  }

  TemporaryFolder folder_;
};

TEST_F(RectificationFaults, LogsThatAreNone)
{
  fs::create_directory(folder_.path("empty"));
  refuse({"--carmen", folder_.path("no log")}, 3, "no log");
  refuse({"--carmen", folder_.write("log", "")}, 3, "is empty");
  refuse({"--carmen", folder_.write("log", "ODOM 0 0 0\n")}, 3, "no FLASER");
  refuse({"--carmen", folder_.write("log", "FLASER 9 1 2 3\n")}, 3, "line 1");
  refuse({"--carmen", folder_.path("empty")}, 3, "is a folder");
  refuse({"--carmen", folder_.write("log", "FLASER 3 nan -1 0 0 0 0 0 0 0 0 host 0\n")},
         4,
         "has no point");
}

TEST_F(RectificationFaults, OdometryNoiseThatIsNone)
{
  for (const std::vector<std::string>& noise : {std::vector<std::string>{"0", "0.3"},
                                                {"0.01", "0"},
                                                {"-0.01", "0.3"},
                                                {"nan", "0.3"},
                                                {"0.01", "inf"},
                                                {"0.01", "10000"},
                                                {"0.01", "degrees"},
                                                {"0.01"},
                                                {}}) {
    std::vector<std::string> arguments =
        joined({folder_.path("none"), "--odometry-noise"}, noise);
    refuse(arguments, 2, "--odometry-noise");
  }
}

TEST_F(RectificationFaults, PosesThatAreMissing)
{
  const std::string session = copyOfRoom(folder_.path("session"));
  const std::string rows = contentOf(session + "/trajectory.txt");
  folder_.write("session/trajectory.txt",
                rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1));
  refuse({session}, 3, "has 23 poses");
  folder_.write("session/trajectory.txt", "0 0 0 zero\n");
  refuse({session}, 3, "trajectory.txt: line 1");
  fs::remove(session + "/trajectory.txt");
  for (int i = 0; i < 24; ++i) {
    const std::string path =
        session + "/observation_00" + (i < 10 ? "0" : "") + std::to_string(i) + ".pcd";
    savePointCloud(path, loadPointCloud(path).cloud);
  }
  refuse({session}, 3, "have no poses");
}

TEST_F(RectificationFaults, NonsenseOnTheCommandLine)
{
  const std::string& session = driftedRoom().session;
  refuse({}, 2, "--carmen");
  refuse({session, "--carmen", "log"}, 2, "--carmen");
  refuse({session, "--every", "2"}, 2, "--every");
  refuse({"--carmen", "log", "--every", "0"}, 2, "--every");
  refuse({"--carmen", "log", "--observations"}, 2, "--observations");
  refuse({"--carmen", "log", "--scale", "0.001"}, 2, "--scale");
  refuse({session, "--mode", "fast"}, 2, "--mode");
  for (const char* bin : {"0", "-1", "nan", "inf", "wide"})
    refuse({session, "--bin", bin}, 2, "--bin");
  refuse({session, "--smoothing", "0.1"}, 2, "--smoothing needs --mode paper");
  for (const char* sigma : {"-1", "nan", "wide", "5.1"})
    refuse({session, "--mode", "paper", "--smoothing", sigma}, 2, "--smoothing");
  refuse({session, "--seed", "-1"}, 2, "--seed");
  refuse({session, "--threads", "-1"}, 2, "--threads");
  expectRefused(runRectification({session}), 2, "--output");
  const ToolRun help = runRectification({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"metres", "--carmen", "--every", "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
}

TEST_F(RectificationFaults, PlacesThatCannotBeWritten)
{
  const std::string log = folder_.write("log", roomLog(false));
  const auto refuseAt = [&](const std::string& output, int code, const char* word) {
    expectRefused(runRectification({"--carmen", log, "-o", output}), code, word);
  };
  refuseAt(log, 5, "log");
  refuseAt(folder_.path("no/where"), 5, "where");
  refuseAt(folder_.path(""), 2, "holds the input");
  const std::string session = copyOfRoom(folder_.path("session"));
  const std::string before = contentOf(session + "/trajectory.txt");
  refuseAt(session, 5, "already holds");
  expectRefused(runRectification({session, "-o", session}), 2, "holds the input");
  EXPECT_EQ(contentOf(session + "/trajectory.txt"), before);
  fs::create_directories(folder_.path("taken/map.pcd"));
  refuseAt(folder_.path("taken"), 5, "map.pcd");
  EXPECT_FALSE(fs::exists(folder_.path("taken/trajectory.txt")));
}

TEST_F(RectificationFaults, AFullDiskLeavesNothing)
{
  RunSettings full;
  full.file_size_limit = 20000;
  expectRefused(
      runRectification(
          {"--carmen", folder_.write("log", roomLog(false)), "-o", folder_.path("out")},
          full),
      5,
      "map.pcd");
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

TEST_F(RectificationFaults, AnInterruptionLeavesNothing)
{
  RunSettings interrupted;
  interrupted.interrupt_after = 0.05;
  expectRefused(
      runRectification({driftedRoom().session, "-o", folder_.path("out")}, interrupted),
      130,
      "interrupted");
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

/** Runs on a folder whose poses must not change. */
void
expectPosesAsTheyCame(const std::string& session, const std::string& output)
{
  const ToolRun run = runRectification({session, "-o", output}).succeeded();
  const auto report = jsonOfFile(output + "/report.json");
  const auto outcome = report.at("outcome").get<std::string>();
  EXPECT_NE(outcome, "rectified");
  const auto reason = report.at(outcome).get<std::string>();
  EXPECT_FALSE(reason.empty());
  EXPECT_THAT(run.out, HasSubstr(outcome + ":"));
  EXPECT_THAT(run.out, HasSubstr(reason));
  EXPECT_EQ(run.errorLines(), 1U) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the poses are as they came: " + reason));
  const Trajectory before = loadTrajectory(session + "/trajectory.txt");
  const Trajectory after = loadTrajectory(output + "/trajectory.txt");
  ASSERT_EQ(after.poses.size(), before.poses.size());
  for (std::size_t i = 0; i < after.poses.size(); ++i)
    EXPECT_TRUE(after.poses[i].isApprox(before.poses[i], 1e-9));
}

TEST_F(RectificationFaults, OneObservationIsLeftWhereItIs)
{
  const std::string session = folder_.path("session");
  fs::create_directory(session);
  fs::copy(driftedRoom().session + "/observation_0000.pcd", session);
  Trajectory one;
  one.stamps = {3};
  one.poses = {driftedRoom().drifted.poses[0]};
  saveTrajectory(session + "/trajectory.txt", one);
  expectPosesAsTheyCame(session, folder_.path("out"));
}

TEST_F(RectificationFaults, ObservationsThatShareNothingAreLeftWhereTheyAre)
{
  const std::string session = copyOfRoom(folder_.path("session"));
  Trajectory apart = driftedRoom().truth;
  for (std::size_t i = 0; i < apart.poses.size(); ++i)
    apart.poses[i].translation().x() += 200.0 * static_cast<double>(i);
  saveTrajectory(session + "/trajectory.txt", apart);
  for (int i = 0; i < 24; ++i) { // without VIEWPOINTs there is no other warning
    const std::string path =
        session + "/observation_00" + (i < 10 ? "0" : "") + std::to_string(i) + ".pcd";
    savePointCloud(path, loadPointCloud(path).cloud);
  }
  expectPosesAsTheyCame(session, folder_.path("out"));
}

TEST_F(RectificationFaults, ManyViewpointsThatDifferAreOneLine)
{
  const std::string session = copyOfRoom(folder_.path("session"));
  const ToolRun run = runRectification({session, "-o", folder_.path("out")});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("further files likewise"));
  EXPECT_LE(run.errorLines(), 2U) << run.err;
}

} // namespace
} // namespace pcl::acmap::test
