#include "chain_runs.h"
#include "plane_runs.h"
#include "small_disk.h"
#include "tool_cases.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/** Maps of posed observations, made by several processes of mpirun. */
class RanksTest : public ChainTest {
protected:
  void
  SetUp() override
  {
    ChainTest::SetUp();
    input_ = posedObservations();
  }

  /** \param[in] other command of the last process, for a fault of it; else the tool */
  ToolRun
  runRanks(int ranks,
           const std::string& output,
           const std::vector<std::string>& options = {},
           const std::string& other = {}) const
  {
    std::vector<std::string> tool =
        joined({ACMAP_COMPACT_MAPPING, input_, "-o", output, "--no-pictures"},
               joined(way_, options));
    std::vector<std::string> arguments = {"--oversubscribe"};
    const auto add = [&](int processes, const std::vector<std::string>& command) {
      arguments.insert(arguments.end(), {"-n", std::to_string(processes)});
      arguments.insert(arguments.end(), command.begin(), command.end());
    };
    add(other.empty() ? ranks : ranks - 1, tool);
    if (!other.empty()) {
      arguments.emplace_back(":");
      std::vector<std::string> command = joined({"/bin/sh", "-c", other, "sh"}, tool);
      add(1, command);
    }
    RunSettings settings;
    settings.environment = {{"DISPLAY", std::nullopt},
                            {"OMPI_ALLOW_RUN_AS_ROOT", "1"},
                            {"OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"},
                            // which containers forbid or have not, with a message
                            {"OMPI_MCA_btl", "^tcp"},
                            {"OMPI_MCA_btl_vader_single_copy_mechanism", "none"}};
    if (!other.empty()) // a busy machine may need seconds to clean up after a fault
      settings.environment.emplace_back("OMPI_MCA_odls_base_sigkill_timeout", "10");
    ToolRun run = runTool(ACMAP_MPIRUN, arguments, settings);
    run.err = withoutRemarksOfMpirun(run.err);
    return run;
  }

  /** \brief Without what mpirun says of processes that failed, between two lines of dashes,
   * and of the machine: Open MPI 5 knows no option that silences it. */
  static std::string
  withoutRemarksOfMpirun(const std::string& told)
  {
    std::istringstream lines(told);
    std::string kept;
    bool is_remark = false;
    for (std::string line; std::getline(lines, line);)
      if (line.compare(0, 10, "----------") == 0)
        is_remark = !is_remark;
      else if (!is_remark && line.compare(0, 6, "hwloc/") != 0)
        kept += line + "\n";
    return kept;
  }

  std::map<std::string, std::string>
  mapBy(int ranks, const std::vector<std::string>& options = {})
  {
    const std::string output = folder_.path("by" + std::to_string(ranks));
    fs::remove_all(output);
    const ToolRun run = runRanks(ranks, output, options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(hiddenIn(output), IsEmpty());
    const auto report = jsonOfFile(output + "/report.json");
    const auto& told = report.at("stages")[0].at("details");
    EXPECT_EQ(told.contains("ranks"), ranks > 1);
    if (ranks > 1) {
      EXPECT_EQ(told.at("ranks").at("processes"), ranks);
      EXPECT_GT(told.at("ranks").at("bytes"), 0);
      EXPECT_THAT(run.out, HasSubstr("ranks:"));
    }
    return resultsIn(output);
  }

  /** Spoils the last observation, which the last rank reads. */
  std::string
  spoilLast() const
  {
    const std::string name = "observation_0002.pcd";
    std::ofstream(input_ + "/" + name) << "no PCD";
    return name;
  }

  void
  expectNothingOf(const std::string& output) const
  {
    EXPECT_FALSE(fs::exists(output + "/map.json"));
    if (fs::exists(output)) {
      EXPECT_THAT(hiddenIn(output), IsEmpty());
    }
  }

  std::string input_;
  std::string out_ = folder_.path("out");

  std::vector<std::string> way_ = {"--no-rectification"};
};

TEST_F(RanksTest, GiveTheSameBytes)
{
  const auto alone = mapBy(1);
  EXPECT_THAT(alone, Not(IsEmpty()));
  EXPECT_THAT(differing(mapBy(2), alone), IsEmpty());
  EXPECT_THAT(differing(mapBy(4), alone), IsEmpty()); // one has no observation
}

TEST_F(RanksTest, KeepTheirMemoryLimitsWithTheSameBytes)
{
  const auto alone = mapBy(1);
  EXPECT_THAT(differing(mapBy(2, {"--memory-limit", "1GB"}), alone), IsEmpty());
}

TEST_F(RanksTest, GiveTheSameBytesOfOneCloud)
{
  mapBy(1);
  fs::rename(folder_.path("by1/map.pcd"), folder_.path("cloud.pcd"));
  input_ = folder_.path("cloud.pcd");
  way_.clear();
  const auto alone = mapBy(1);
  EXPECT_THAT(differing(mapBy(3), alone), IsEmpty());
}

TEST_F(RanksTest, ABrokenObservationOfARankIsNamedInOneLine)
{
  const std::string name = spoilLast();
  const ToolRun run = runRanks(2, out_);
  EXPECT_EQ(run.exit_code, 3) << run.err;
  EXPECT_THAT(run.err, HasSubstr(name));
  EXPECT_EQ(run.errorLines(), 1U) << run.err;
  expectNothingOf(out_);
}

TEST_F(RanksTest, BrokenObservationsOfARankAreLeftOut)
{
  spoilLast();
  const auto alone = mapBy(1, {"--skip-broken"});
  EXPECT_THAT(differing(mapBy(2, {"--skip-broken"}), alone), IsEmpty());
}

TEST_F(RanksTest, AFullDiskEndsAllInOneLine)
{
  if (!SmallDisk::isAllowed())
    GTEST_SKIP() << "this user may mount no disk, not even in a world of its own";
  const std::string bad = folder_.path("bad"), output = bad + "/map";
  fs::create_directory(bad);
  {
    const SmallDisk disk(bad, 1 << 16);
    disk.fill(5);
    const ToolRun run = runRanks(3, output);
    EXPECT_EQ(run.exit_code, 5) << run.err;
    EXPECT_THAT(run.err, HasSubstr(output));
    EXPECT_EQ(run.errorLines(), 1U) << run.err;
    expectNothingOf(output);
  }
  EXPECT_THAT(differing(mapBy(3), mapBy(1)), IsEmpty());
}

TEST_F(RanksTest, WrongOptionsAreToldOnce)
{
  const ToolRun run = runRanks(3, out_, {"--nonsense"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.errorLines(), 1U) << run.err;
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(RanksTest, ARankThatIsKilledEndsTheRunWithoutAHalfMap)
{
  const ToolRun run =
      runRanks(2, out_, {}, "\"$@\" & p=$!; sleep 0.4; kill -9 $p; kill -9 $$");
  EXPECT_NE(run.exit_code, 0);
  expectNothingOf(out_);
  // a later run makes it
  const ToolRun again = runRanks(2, out_);
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

} // namespace
} // namespace pcl::acmap::test
