#include "every_tool.h"
#include "repetitions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Stopwatch {
public:
  double
  seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

/** \brief Results of an uninterrupted run of a tool, and its duration. */
struct Undisturbed {
  explicit Undisturbed(const ToolRow& row)
  {
    const TemporaryFolder folder;
    const Stopwatch watch;
    const ToolRun run =
        runRow(row, [&](const std::string& output) { return folder.path(output); });
    seconds = watch.seconds();
    EXPECT_EQ(run.exit_code, 0) << run.err;
    results = resultsBelow(folder.path(""));
  }

  std::map<std::string, std::string> results;
  double seconds = 0;
};

/** \brief The uninterrupted run of each tool, once per program. */
const Undisturbed&
undisturbed(const ToolRow& row)
{
  static std::map<const ToolRow*, Undisturbed> all;
  smallInputs(); // not included in the measured time
  return all.try_emplace(&row, row).first->second;
}

/** \brief Number of runs by outcome. */
struct Tally {
  int stopped = 0;
  int finished = 0; ///< before the interruption
  int with_results = 0;

  /** \brief Are more interruptions needed? Some come too late. */
  bool
  isWanted(int moments) const
  {
    return stopped < moments && finished < 2 * moments + 20;
  }

  void
  print(const std::string& tool) const
  {
    std::cout << tool << ": stopped " << stopped << ", of which with results "
              << with_results << "; done before " << finished << "\n";
  }
};

/** \brief Runs a tool in a folder, and stops it at a random moment. */
class Stopping {
public:
  Stopping(const ToolRow& row, const Undisturbed& whole)
  : row_(row)
  , whole_(whole)
  , seconds_(whole.seconds)
  {}

  ToolRun
  stop(int signal, const TemporaryFolder& folder)
  {
    RunSettings settings;
    settings.interruption = signal;
    settings.interrupt_after =
        std::uniform_real_distribution<double>(0, seconds_)(random_);
    const Stopwatch watch;
    const ToolRun run = this->run(folder, settings);
    if (run.exit_code == 0) // too late: this run was faster than the first one
      seconds_ = 0.8 * std::min(seconds_, watch.seconds());
    return run;
  }

  ToolRun
  run(const TemporaryFolder& folder, const RunSettings& settings = {}) const
  {
    return runRow(
        row_, [&](const std::string& output) { return folder.path(output); }, settings);
  }

  /** \brief Checks that each file is complete.
   * \param[out] any true if there is a file */
  void
  expectWhole(const TemporaryFolder& folder, bool& any) const
  {
    any = false;
    for (const auto& [name, bytes] : resultsBelow(folder.path(""))) {
      if (name.find("/.") != std::string::npos || name.front() == '.')
        continue; // in a hidden folder
      any = true;
      if (fs::path(name).filename() == "session.yaml")
        continue; // an interrupted recording is finished with fewer frames
      const auto there = whole_.results.find(name);
      ASSERT_NE(there, whole_.results.end()) << name;
      EXPECT_TRUE(bytes == there->second) << name << " is not whole";
    }
  }

private:
  const ToolRow& row_;
  const Undisturbed& whole_;
  double seconds_;
  std::mt19937 random_{14};
};

/** \brief Checks that the results are exactly those of an uninterrupted run. */
void
expectSame(const TemporaryFolder& folder, const Undisturbed& whole)
{
  const auto results = resultsBelow(folder.path(""));
  EXPECT_EQ(results.size(), whole.results.size());
  for (const auto& [name, bytes] : whole.results) {
    const auto there = results.find(name);
    ASSERT_NE(there, results.end()) << name << " is missing";
    EXPECT_TRUE(bytes == there->second) << name << " differs";
  }
  EXPECT_THAT(hiddenBelow(folder.path("")), IsEmpty());
}

/** \brief Kills a tool repeatedly, and lets the next run finish each time. */
void
killAtRandom(const ToolRow& row, int moments)
{
  if (!isWorthwhile(row))
    return;
  SCOPED_TRACE(row.tool);
  const Undisturbed& whole = undisturbed(row);
  Stopping stopping(row, whole);
  Tally tally;
  for (int i = 0; tally.isWanted(moments) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const TemporaryFolder folder;
    const bool is_killed = stopping.stop(SIGKILL, folder).signal == SIGKILL;
    ++(is_killed ? tally.stopped : tally.finished);
    bool any = false;
    stopping.expectWhole(folder, any);
    tally.with_results += is_killed && any ? 1 : 0;
    ToolRun next = stopping.run(folder);
    EXPECT_THAT(hiddenBelow(folder.path("")), IsEmpty());
    if (next.exit_code == 5) {
      // the folder already has results: none are overwritten
      EXPECT_THAT(next.err, HasSubstr(" already")) << next.err;
      for (const std::string& output : outputsOf(row))
        fs::remove_all(folder.path(output));
      next = stopping.run(folder);
    }
    EXPECT_EQ(next.exit_code, 0) << next.err;
    expectSame(folder, whole);
  }
  tally.print(row.tool);
  if (!testing::Test::HasFailure()) {
    EXPECT_GT(tally.stopped, 0) << "no moment came before the end";
  }
}

/** \brief Interrupts a tool repeatedly, by SIGINT and SIGTERM in turn. */
void
interruptAtRandom(const ToolRow& row, int moments, bool is_first_terminated)
{
  if (!isWorthwhile(row))
    return;
  SCOPED_TRACE(row.tool);
  const Undisturbed& whole = undisturbed(row);
  Stopping stopping(row, whole);
  Tally tally;
  for (int i = 0; tally.isWanted(moments); ++i) {
    SCOPED_TRACE(i);
    const TemporaryFolder folder;
    const ToolRun run =
        stopping.stop((i % 2 == 0) != is_first_terminated ? SIGINT : SIGTERM, folder);
    EXPECT_THAT(hiddenBelow(folder.path("")), IsEmpty());
    bool any = false;
    stopping.expectWhole(folder, any);
    if (run.exit_code == 0) {
      ++tally.finished;
      continue;
    }
    ++tally.stopped;
    tally.with_results += any ? 1 : 0;
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.errorLines(), 1U) << run.err;
    EXPECT_THAT(run.err, StartsWith(row.tool + ": interrupted"));
    const bool lacks_pictures =
        run.err.find("all but the pictures") != std::string::npos;
    if (row.keeps.empty() && !lacks_pictures) {
      EXPECT_EQ(folder.count(), 0);
    }
  }
  tally.print(row.tool);
  EXPECT_GT(tally.stopped, 0) << "no moment came before the end";
}

TEST(RandomMoments, AKilledToolLeavesNothingHalfAndNothingThatStays)
{
  for (const ToolRow& row : everyTool())
    if (row.keeps.empty())
      killAtRandom(row, wantedMoments().value_or(1));
}

/** \brief The only row of a tool. */
const ToolRow&
rowOf(const std::string& tool)
{
  return *std::find_if(everyTool().begin(), everyTool().end(), [&](const ToolRow& row) {
    return row.tool == tool;
  });
}

TEST(RandomMoments, AKilledChainGoesOn)
{
  killAtRandom(rowOf("pcl_compact_mapping"),
               wantedMoments().value_or(repetitions(2, 5)));
}

TEST(RandomMoments, AKilledStereoRunBeginsAnew)
{
  killAtRandom(rowOf("pcl_active_stereo"), wantedMoments().value_or(repetitions(1, 2)));
}

TEST(RandomMoments, AKilledRecorderLeavesWholeFrames)
{
  killAtRandom(rowOf("pcl_digiclops_grabber"),
               wantedMoments().value_or(repetitions(2, 5)));
}

TEST(RandomMoments, AKilledRecordingIsReadToItsLastFrame)
{
  const TemporaryFolder folder;
  const std::string recorded = folder.path("recorded");
  RunSettings settings;
  settings.interruption = SIGKILL;
  settings.interrupt_when = [&] { return fs::exists(recorded + "/frame_000005.acf"); };
  const ToolRun killed = runRow(
      rowOf("pcl_digiclops_grabber"),
      [&](const std::string& name) { return folder.path(name); },
      settings);
  ASSERT_EQ(killed.signal, SIGKILL);
  ASSERT_FALSE(fs::exists(recorded + "/session.yaml"));
  const ToolRun stereo =
      runTool(ACMAP_TOOLS "/pcl_active_stereo",
              {recorded, "-o", folder.path("read"), "--min-depth", "1"});
  EXPECT_EQ(stereo.exit_code, 0);
  EXPECT_THAT(stereo.err, HasSubstr("was not finished"));
  EXPECT_TRUE(contentOf(folder.path("read/observation_0000.pcd")) ==
              contentOf(smallInputs().path("posed/observation_0000.pcd")));
}

TEST(RandomMoments, AnInterruptedToolSaysSoAndCleansUp)
{
  bool is_first_terminated = false; // tools alternate if each is stopped only once
  for (const ToolRow& row : everyTool()) {
    interruptAtRandom(
        row, wantedMoments().value_or(repetitions(1, 2)), is_first_terminated);
    is_first_terminated = !is_first_terminated;
  }
}

} // namespace
} // namespace pcl::acmap::test
