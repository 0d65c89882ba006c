#include "temporary_folder.h"
#include "tool_cases.h"
#include "visual_egomotion_runs.h"

#include <gmock/gmock.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <thread>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class EgomotionFaults : public testing::Test {
protected:
  void
  refuse(std::vector<std::string> input, int code, const std::string& word) const
  {
    input.insert(input.end(), {"-o", folder_.path("out")});
    expectRefused(runEgomotion(input), code, word);
    EXPECT_FALSE(fs::exists(folder_.path("out")));
  }

  /** A hall whose fourth observation is invalid. */
  void
  refuseWith(const std::function<void(PCLPointCloud2&)>& edit, const std::string& word)
  {
    const std::string session = folder_.path("session");
    fs::remove_all(session);
    change(observationIn(copyOfHall(session), 3), edit);
    refuse({session}, 3, word);
  }

  TemporaryFolder folder_;
};

TEST_F(EgomotionFaults, InputsThatAreNone)
{
  refuse({folder_.path("none.pcd"), folder_.path("none2.pcd")}, 3, "none.pcd");
  fs::create_directory(folder_.path("empty"));
  refuse({folder_.path("empty"), hall().session}, 3, "is a folder");
  refuse({}, 2, "observations");
}

TEST_F(EgomotionFaults, OneObservationHasNoMotion)
{
  refuse({observationIn(hall().session, 2)}, 4, "two are needed");
  fs::create_directory(folder_.path("one"));
  fs::copy(observationIn(hall().session, 2), folder_.path("one"));
  refuse({folder_.path("one")}, 4, "two are needed");
}

TEST_F(EgomotionFaults, ObservationsThatCannotBeUsed)
{
  refuseWith([](PCLPointCloud2& cloud) { dropField(cloud, "rgb"); },
             "observation_0003.pcd: has no image, the observations before have");
  refuseWith(
      [](PCLPointCloud2& cloud) {
        cloud.width *= cloud.height;
        cloud.height = 1;
        cloud.row_step = cloud.width * cloud.point_step;
      },
      "observation_0003.pcd: has no image, the observations before have");
  refuseWith(
      [](PCLPointCloud2& cloud) {
        cloud.height /= 2;
        cloud.data.resize(std::size_t{cloud.height} * cloud.row_step);
      },
      "160 x 60 points, the observations before have 160 x 120");
}

TEST_F(EgomotionFaults, OddStampsAreNoReasonToGiveUp)
{
  const std::string session = copyOfHall(folder_.path("session"));
  folder_.write("session/trajectory.txt", "0 0 zero\n");
  const ToolRun run = runEgomotion({session, "-o", folder_.path("out")});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("trajectory.txt: line 1"));
  EXPECT_EQ(loadTrajectory(folder_.path("out/trajectory.txt")).stamps[5], 5);
}

TEST_F(EgomotionFaults, TruthThatDoesNotFit)
{
  const std::string& session = hall().session;
  refuse({session, "--truth", folder_.path("none.txt")}, 3, "none.txt");
  refuse({session, "--truth", folder_.write("t.txt", "0 0 0 0 0 0 0 1\n")},
         3,
         "has 1 poses, none for observation_0001.pcd");
  for (const char* name : {"a.pcd", "b.pcd"})
    fs::copy(observationIn(session, 0), folder_.path(name));
  refuse({folder_.path("a.pcd"),
          folder_.path("b.pcd"),
          "--truth",
          session + "/trajectory.txt"},
         3,
         "has 6 poses for 2 observations, and a.pcd has no number");
}

TEST_F(EgomotionFaults, NonsenseOnTheCommandLine)
{
  const std::string& session = hall().session;
  for (const char* reach : {"0", "-1", "nan", "far"})
    refuse({session, "--max-translation", reach}, 2, "--max-translation");
  for (const char* turn : {"-1", "181", "nan"})
    refuse({session, "--max-rotation", turn}, 2, "--max-rotation");
  for (const char* keypoints : {"9", "-20", "1.5", "100001"})
    refuse({session, "--keypoints", keypoints}, 2, "--keypoints");
  refuse({session, "--threads", "-1"}, 2, "--threads");
  refuse({session, "--scale", "0"}, 2, "--scale");
  expectRefused(runEgomotion({session}), 2, "--output");
  const ToolRun help = runEgomotion({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"metres", "degrees", "--6dof", "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
}

TEST_F(EgomotionFaults, PlacesThatCannotBeWritten)
{
  const auto refuseAt = [&](const std::string& output, int code, const char* word) {
    expectRefused(runEgomotion({hall().session, "-o", output}), code, word);
  };
  refuseAt(folder_.write("file", ""), 5, "file");
  refuseAt(folder_.path("no/where"), 5, "where");
  const std::string session = copyOfHall(folder_.path("session"));
  const std::set<std::string> before = filesIn(session);
  expectRefused(runEgomotion({session, "-o", session}), 2, "holds the input");
  expectRefused(
      runEgomotion(
          {observationIn(session, 0), observationIn(session, 1), "-o", session}),
      2,
      "holds the input");
  refuseAt(session, 5, "already holds");
  EXPECT_EQ(filesIn(session), before);
  for (const char* name :
       {"matches_0007.png", "map.pcd", "map.json", "plan.png", "report.json"}) {
    fs::create_directory(folder_.path("used"));
    folder_.write(std::string("used/") + name, "");
    refuseAt(folder_.path("used"), 5, name);
    fs::remove_all(folder_.path("used"));
  }
}

TEST_F(EgomotionFaults, AFolderThatAnotherRunFilledMeanwhile)
{
  const std::string output = folder_.path("out");
  std::atomic<bool> has_ended{false};
  const auto other = std::async(std::launch::async, [&] {
    while (!fs::exists(output) && !has_ended)
      std::this_thread::yield();
    folder_.write("out/trajectory.txt", "");
  });
  expectRefused(runEgomotion({hall().session, "-o", output}), 5, "trajectory.txt");
  has_ended = true;
  other.wait();
  EXPECT_EQ(filesIn(output), std::set<std::string>{"trajectory.txt"});
}

TEST_F(EgomotionFaults, AFullDiskLeavesNothing)
{
  RunSettings full;
  full.file_size_limit = 100000;
  expectRefused(runEgomotion({hall().session, "-o", folder_.path("out")}, full),
                5,
                "observation_0000.pcd");
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

TEST_F(EgomotionFaults, AnInterruptionLeavesNothing)
{
  std::vector<std::string> arguments = {"-o", folder_.path("out")};
  for (std::size_t i = 0; i < 600; ++i)
    arguments.push_back(observationIn(hall().session, i % 6));
  RunSettings interrupted;
  interrupted.interrupt_after = 0.2;
  expectRefused(runEgomotion(arguments, interrupted), 130, "interrupted");
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

} // namespace
} // namespace pcl::acmap::test
