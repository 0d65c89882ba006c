#include "chain_runs.h"
#include "plane_runs.h"
#include "tool_cases.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ChainInterruption : public ChainTest {
protected:
  std::string
  stage(const std::string& name) const
  {
    return out_ + "/stages/" + name;
  }

  /** \brief Settings that stop a run as soon as its first observation is written. */
  RunSettings
  stopAfterObservation(int signal) const
  {
    RunSettings settings;
    settings.interruption = signal;
    settings.interrupt_when = [=] { return fs::exists(first_); };
    return settings;
  }

  ToolRun
  run(const RunSettings& settings = {}) const
  {
    return runSessionChain(session_, out_, {"--threads", "1"}, settings);
  }

  /** \brief Runs to the end, and checks that the results are those of an uninterrupted
   * run. */
  void
  finish() const
  {
    const ToolRun last = run();
    EXPECT_EQ(last.exit_code, 0) << last.err;
    EXPECT_THAT(differing(resultsIn(out_), resultsIn(map_)), IsEmpty());
    EXPECT_THAT(hiddenIn(out_), IsEmpty());
  }

  std::string out_ = folder_.path("out");
  std::string first_ = stage("observations") + "/observation_0000.pcd";
};

TEST_F(ChainInterruption, FinishedObservationsAreNotMatchedAnew)
{
  const ToolRun stopped = run(stopAfterObservation(SIGINT));
  expectRefused(stopped, 130, "kept in " + out_ + "/stages");
  EXPECT_THAT(stopped.err, HasSubstr("observations in part"));
  EXPECT_THAT(hiddenIn(out_), IsEmpty());
  EXPECT_FALSE(fs::exists(out_ + "/map.json"));
  EXPECT_FALSE(fs::exists(out_ + "/report.json"));
  ASSERT_TRUE(fs::exists(first_));
  ASSERT_FALSE(fs::exists(stage("observations") + "/observation_0002.pcd"));
  const auto time = fs::last_write_time(first_);
  finish();
  EXPECT_EQ(fs::last_write_time(first_), time);
  const auto report = jsonOfFile(out_ + "/report.json");
  const auto whole = jsonOfFile(map_ + "/report.json");
  EXPECT_EQ(report.at("stages")[0].at("details").at("observations"),
            whole.at("stages")[0].at("details").at("observations"));
  EXPECT_EQ(stagesOf(out_), madeStages(out_));
  EXPECT_EQ(run().exit_code, 0);
  EXPECT_THAT(madeStages(out_), IsEmpty());
}

TEST_F(ChainInterruption, NothingFinishedLeavesNothing)
{
  RunSettings settings;
  settings.interrupt_when = [&] { return fs::exists(stage("observations")); };
  expectRefused(run(settings), 130, "interrupted");
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(ChainInterruption, StagesBeforeAreKept)
{
  fs::remove_all(map_ + "/stages/map");
  fs::remove(map_ + "/map.json");
  RunSettings settings;
  settings.interrupt_when = [&] { return fs::exists(map_ + "/stages/map/stage.json"); };
  const ToolRun stopped = runAgain({}, settings);
  expectRefused(stopped, 130, "next run: observations, egomotion, rectification");
  EXPECT_FALSE(fs::exists(map_ + "/map.json"));
  EXPECT_THAT(hiddenIn(map_), IsEmpty());
  EXPECT_EQ(runAgain().exit_code, 0);
  EXPECT_THAT(madeStages(map_), ElementsAre("map"));
}

TEST_F(ChainInterruption, AMapThatIsThereSurvivesTheNextOnesInterruption)
{
  const auto before = resultsIn(map_);
  const std::string notes = map_ + "/stages/map/stage.json";
  RunSettings settings;
  settings.interrupt_when = [&] {
    return contentOf(notes).find("\"finished\": false") != std::string::npos;
  };
  const ToolRun run = runAgain({"--no-rectification"}, settings);
  expectRefused(run, 130, "next run: observations, egomotion");
  EXPECT_THAT(run.err, Not(HasSubstr("egomotion, ")));
  EXPECT_THAT(differing(resultsIn(map_), before), IsEmpty());
  // and its files are recorded, so that a later map replaces them
  EXPECT_EQ(runAgain({"--no-rectification"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(map_ + "/pictures/energy.png"));
}

TEST_F(ChainInterruption, AKilledRunKeepsItsObservationsAndLeavesNothingThatStays)
{
  const ToolRun killed = run(stopAfterObservation(SIGKILL));
  EXPECT_EQ(killed.signal, SIGKILL);
  EXPECT_THAT(hiddenIn(out_), Not(IsEmpty()));
  const auto time = fs::last_write_time(first_);
  finish();
  EXPECT_EQ(fs::last_write_time(first_), time);
}

/** \brief Moves the time at which a frame was recorded. */
void
delayFrame(const std::string& path, std::int64_t microseconds)
{
  constexpr std::size_t place = 28; // of the stamp, see doc/acquisition/frame_file.md
  std::string bytes = contentOf(path);
  const std::size_t end = bytes.size() - sizeof(std::uint32_t);
  std::int64_t stamp = 0;
  std::memcpy(&stamp, &bytes[place], sizeof(stamp));
  stamp += microseconds;
  std::memcpy(&bytes[place], &stamp, sizeof(stamp));
  const auto checksum = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(end)));
  std::memcpy(&bytes[end], &checksum, sizeof(checksum));
  std::ofstream(path, std::ios::binary) << bytes;
}

void
delayThirdObservation(const std::string& session, std::int64_t microseconds)
{
  for (const char* name : {"/frame_000008.acf",
                           "/frame_000009.acf",
                           "/frame_000010.acf",
                           "/frame_000011.acf"})
    delayFrame(session + name, microseconds);
}

/** The second observation ends where the third begins, which would be in half a minute:
 * the interruption comes before, however busy the machine is. */
TEST_F(ChainInterruption, AReplayEndsWithAMapOfWhatItHasSeen)
{
  constexpr std::int64_t half_minute = 30000000;
  delayThirdObservation(session_, half_minute);
  const std::string first = stage("replay") + "/observation_0000.pcd";
  RunSettings settings;
  settings.interrupt_when = [&] { return fs::exists(first); };
  const ToolRun stopped = runSessionChain(session_, out_, {"--as-recorded"}, settings);
  expectRefused(stopped, 130, "observation by then is in " + out_);
  EXPECT_THAT(stopped.err, HasSubstr("interrupted; the map of the 1 "));
  EXPECT_TRUE(fs::exists(out_ + "/map.glb"));
  EXPECT_THAT(hiddenIn(out_), IsEmpty());
  // an interrupted replay is no result that a later one would take
  delayThirdObservation(session_, -half_minute);
  runSessionChain(session_, out_, {"--as-recorded"}).succeeded();
  EXPECT_EQ(contentOf(out_ + "/map.json"), contentOf(map_ + "/map.json"));
}

TEST_F(ChainInterruption, AReplayWithoutAnObservationLeavesNothing)
{
  RunSettings settings;
  settings.interrupt_after = 0;
  expectRefused(
      runSessionChain(session_, out_, {"--as-recorded"}, settings), 130, "interrupted");
  EXPECT_FALSE(fs::exists(out_ + "/map.json"));
  EXPECT_FALSE(fs::exists(stage("replay")));
}

} // namespace
} // namespace pcl::acmap::test
