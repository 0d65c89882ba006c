#include "active_stereo_runs.h"
#include "digiclops_runs.h"
#include "json_file.h"
#include "simulated_runs.h"

#include <pcl/acquisition/frame_file.h>
#include <pcl/acquisition/trinocular_recorder.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/** \brief Grabs from a recording instead of a camera. */
class DigiclopsRecording : public ActiveStereoRuns {
protected:
  /** \brief Grabs clouds and a session of the input.
   * \param[in] more options */
  ToolRun
  grab(const std::vector<std::string>& more = {},
       const RunSettings& settings = {}) const
  {
    return runGrabber(
        joined({"--device", input_, "--pcd", clouds_, "-o", recorded_}, more),
        settings);
  }

  /** \brief A copy of the session, which a test may modify. */
  std::string
  copy() const
  {
    fs::copy(session(), folder_.path("copy"));
    return folder_.path("copy");
  }

  std::string clouds_ = folder_.path("clouds");
  std::string recorded_ = folder_.path("recorded");
};

TEST_F(DigiclopsRecording, CloudsAreThoseOfActiveStereoAndTheSessionIsTheRecording)
{
  const ToolRun run = grab().succeeded();
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("observations: 2\n"));
  EXPECT_THAT(run.out, HasSubstr("14, rectified"));
  runSession().succeeded();
  expectSameFiles(clouds_, out_);
  EXPECT_EQ(namesIn(recorded_).size(), 16u); // 14 frames, rig, session
  for (const std::string& name : namesIn(recorded_))
    EXPECT_TRUE(contentOf(recorded_ + "/" + name) == contentOf(session() + "/" + name))
        << name;
}

TEST_F(DigiclopsRecording, MethodAndDepthsAreThoseOfActiveStereo)
{
  const std::vector<std::string> choices = {
      "--method", "median", "--min-depth", "1.2", "--max-depth", "4"};
  grab(choices).succeeded();
  runSession(choices).succeeded();
  expectSameFiles(clouds_, out_);
}

TEST_F(DigiclopsRecording, RawFramesAreRecordedRawAndRectifiedForTheClouds)
{
  input_ = folder_.path("raw");
  runTool(ACMAP_SIMULATED_RIG,
          {"-o",
           input_,
           "--scene",
           filmed_->path("room.yaml"),
           "--patterns",
           "5",
           "--observations",
           "1",
           "--cameras",
           ACMAP_SHARE "/rigs/digiclops_built.yaml"})
      .succeeded();
  const ToolRun run = grab({"--min-depth", "1"}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("6, raw"));
  runSession({"--min-depth", "1"}).succeeded();
  expectSameFiles(clouds_, out_);
  for (const char* name : {"rig.yaml", "frame_000005.acf"})
    EXPECT_TRUE(contentOf(recorded_ + "/" + name) == contentOf(input_ + "/" + name));
}

TEST_F(DigiclopsRecording, ObservationsAreAsManyAsAreWanted)
{
  grab({"--observations", "1"}).succeeded();
  EXPECT_THAT(namesIn(clouds_), ElementsAre("observation_0000.pcd"));
  EXPECT_EQ(framesOf(recorded_).size(), 7u);
}

TEST_F(DigiclopsRecording, BrokenFramesAreLeftOutAndTold)
{
  input_ = copy();
  fs::resize_file(input_ + "/frame_000009.acf", 2000);
  fs::remove(input_ + "/frame_000003.acf");
  const std::string report = folder_.path("report.json");
  const ToolRun run = grab({"--report", report}).succeeded();
  EXPECT_THAT(run.err, HasSubstr("frame 9"));
  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["recording"]["broken_frames"], nlohmann::json({9}));
  EXPECT_EQ(json["frames"], 12);
  EXPECT_EQ(framesOf(recorded_).size(), 12u);
  runSession().succeeded();
  expectSameFiles(clouds_, out_);
}

TEST_F(DigiclopsRecording, AShotThatComesTwiceCountsOnceInBoth)
{
  input_ = copy();
  TrinocularFrame again = *framesOf(session())[2];
  again.number = 14;
  saveTrinocularFrame(input_ + "/frame_000014.acf", again);
  const ToolRun run = grab().succeeded();
  EXPECT_THAT(run.err, HasSubstr("frame 14: the shot"));
  EXPECT_EQ(framesOf(recorded_).size(), 14u);
  input_ = recorded_;
  runSession().succeeded();
  expectSameFiles(clouds_, out_);
}

TEST_F(DigiclopsRecording, ReportTellsOfEachObservation)
{
  const std::string report = folder_.path("report.json");
  const ToolRun run = grab({"--report", report, "--quiet"}).succeeded();
  EXPECT_EQ(run.out + run.err, "");
  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["frames"], 14);
  EXPECT_EQ(json["recorded_frames"], 14);
  EXPECT_EQ(json["recording"]["is_finished"], true);
  ASSERT_EQ(json["observations"].size(), 2u);
  EXPECT_EQ(json["observations"][1]["shots"], 6);
  EXPECT_GT(json["observations"][1]["points"], 1000);
  std::uintmax_t bytes = 0;
  for (const std::string& name : namesIn(recorded_))
    if (name.rfind("frame_", 0) == 0)
      bytes += fs::file_size(recorded_ + "/" + name);
  EXPECT_EQ(json["recorded_bytes"], bytes);
  for (const char* step : {"open", "grab", "match", "record"})
    EXPECT_TRUE(json["seconds"].contains(step)) << step;
}

TEST_F(DigiclopsRecording, HelpTellsUnitsAndDefaults)
{
  const ToolRun help = runGrabber({"--help"}).succeeded();
  for (const char* word : {"--rate HZ ",
                           "--patterns N ",
                           " 10]",
                           "--settle SECONDS|auto",
                           "--shutter SECONDS|auto",
                           "dB",
                           "--min-depth M ",
                           " 0.5]",
                           "metres",
                           "Exit codes"})
    EXPECT_THAT(help.out, HasSubstr(word));
}

TEST_F(DigiclopsRecording, OptionsThatMakeNoSenseAreRefused)
{
  const auto refused = [&](const std::vector<std::string>& arguments,
                           const char* word) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    expectFails(runGrabber(arguments), 2, word);
  };
  refused({}, "--pcd");
  refused({"--rig", rig_}, "nothing to do");
  refused({"--pcd", clouds_}, "--rig");
  refused({"--pcd", "", "--rig", rig_}, "--pcd");
  refused({"--list", "--pcd", clouds_}, "--list");
  refused({"--pcd", clouds_, "--rig", rig_, "--frames", "3"}, "--patterns 0");
  refused({"--pcd", clouds_, "--rig", rig_, "--patterns", "0"}, "needs patterns");
  refused({"--pcd", clouds_, "--rig", rig_, "--patterns", "256"}, "--patterns");
  for (const char* option : {"--early", "--settle=1", "--observations=2", "--seed=3"})
    refused({"-o", recorded_, "--rig", rig_, "--patterns", "0", option},
            "--patterns 0");
  refused({"-o", recorded_, "--rig", rig_, "--seconds", "-1"}, "--seconds");
  refused({"-o", recorded_, "--rig", rig_, "--shutter", "0"}, "--shutter");
  refused({"-o", recorded_, "--rig", rig_, "--shutter", "fast"}, "--shutter");
  refused({"-o", recorded_, "--rig", rig_, "--settle", "nan"}, "--settle");
  refused({"-o", recorded_, "--rig", rig_, "--rate", "0"}, "--rate");
  refused({"-o", recorded_, "--rig", rig_, "--trigger", "soft"}, "--trigger");
  for (const char* order : {"r,h", "r,h,h", "r,h,v,", "rhv", "r,h,x", ",r,h,v"})
    refused({"-o", recorded_, "--rig", rig_, "--channel-order", order}, "r,h,v");
  for (const char* option :
       {"--rig=a.yaml", "--patterns=3", "--rate=7", "--settle=auto", "--frames=2"})
    refused({"--device", input_, "--pcd", clouds_, option}, "is a recording");
  refused({"--device", input_, "--pcd", clouds_, "-o", clouds_}, "the session, too");
  refused({"--device", input_, "--pcd", input_ + "/."}, "recording's folder");
  refused({"--device", input_, "--pcd", clouds_, "--min-depth", "20"}, "not below");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(DigiclopsRecording, PlacesThatAreTakenAreRefused)
{
  fs::create_directory(clouds_);
  folder_.write("clouds/observation_0007.pcd", "");
  expectFails(grab(), 5, "observation_0007.pcd");
  EXPECT_FALSE(fs::exists(recorded_));
  fs::remove_all(clouds_);
  grab().succeeded();
  fs::remove_all(clouds_);
  expectFails(grab(), 5, "holds a session");
  EXPECT_FALSE(fs::exists(clouds_));
  EXPECT_EQ(framesOf(recorded_).size(), 14u);
}

TEST_F(DigiclopsRecording, ARecordingWithoutFramesGivesNothing)
{
  input_ = copy();
  const auto for_frames = [&](const auto& spoil) {
    for (const std::string& name : namesIn(input_))
      if (name.rfind("frame_", 0) == 0)
        spoil(input_ + "/" + name);
  };
  for_frames([](const std::string& path) { fs::resize_file(path, 100); });
  expectFails(grab(), 3, "is truncated");
  for_frames([](const std::string& path) { fs::remove(path); });
  expectFails(grab(), 3, "no frame that can be read");
  EXPECT_FALSE(fs::exists(clouds_));
  EXPECT_FALSE(fs::exists(recorded_));
  input_ = folder_.path("none");
  fs::create_directory(input_);
  expectFails(grab(), 3, "rig.yaml");
}

TEST_F(DigiclopsRecording, WithoutAPointTheSessionStays)
{
  const ToolRun run = grab({"--min-texture", "128"});
  expectFails(run, 4, "no pixel has a place: ");
  EXPECT_THAT(run.err,
              HasSubstr("frames recorded by then, in " + recorded_ + ": 14\n"));
  EXPECT_FALSE(fs::exists(clouds_));
  EXPECT_TRUE(fs::exists(recorded_ + "/session.yaml"));
}

TEST_F(DigiclopsRecording, DiskIsFullAndWhatIsWholeStays)
{
  RunSettings full;
  full.file_size_limit = 1000; // enough for rig.yaml, but not for a frame
  expectFails(grab({}, full), 5, "frame_000000.acf");
  EXPECT_FALSE(fs::exists(clouds_));
  EXPECT_FALSE(fs::exists(recorded_));

  full.file_size_limit = 300000; // enough for a frame, but not for a cloud
  const ToolRun run = grab({}, full);
  expectFails(run, 5, "observation_0000.pcd");
  EXPECT_THAT(run.err, HasSubstr("frames recorded by then, in " + recorded_ + ": 7\n"));
  EXPECT_FALSE(fs::exists(clouds_));
  EXPECT_EQ(framesOf(recorded_).size(), 7u);
}

TEST_F(DigiclopsRecording, AnInterruptedRunKeepsWholeObservations)
{
  // takes seconds, so that the run cannot finish before the interruption
  constexpr int observations = 250;
  input_ = folder_.path("long");
  {
    TrinocularRecorder recorder(input_, loadTrinocularRig(rig_));
    TrinocularFrame frame = *framesOf(session())[1];
    for (int i = 0; i < observations; ++i) {
      frame.number = static_cast<std::uint64_t>(i);
      frame.observation = i;
      recorder.record(frame);
    }
    recorder.finish();
  }
  RunSettings settings;
  settings.interrupt_when = [&] { return namesIn(recorded_).size() > 4; };
  const ToolRun run = grab({"--min-depth", "0.05", "--threads", "1"}, settings);
  expectFails(run, 130, "interrupted; observations finished by then");
  const std::size_t clouds = namesIn(clouds_).size();
  const std::size_t frames = framesOf(recorded_).size();
  EXPECT_GE(clouds, 1u);
  EXPECT_LT(clouds, 250u);
  // the last recorded observation may not have a cloud yet
  EXPECT_GE(frames, clouds);
  EXPECT_LE(frames, clouds + 1);
  EXPECT_THAT(run.err, HasSubstr(clouds_ + ": " + std::to_string(clouds) + ";"));
  EXPECT_THAT(run.err, HasSubstr(recorded_ + ": " + std::to_string(frames) + "\n"));
}

TEST_F(DigiclopsRecording, AWindowNeedsADisplay)
{
  RunSettings none;
  none.environment = {{"DISPLAY", std::nullopt}};
  expectFails(grab({"--live"}, none), 1, "DISPLAY is not set");
  EXPECT_EQ(folder_.count(), 0);
}

} // namespace
} // namespace pcl::acmap::test
