#include "digiclops_camera_runs.h"
#include "json_file.h"
#include "simulated_runs.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

using DigiclopsCamera = DigiclopsCameraRuns;

TEST_F(DigiclopsCamera, ObservationsAreTheSimulatorsOwn)
{
  const std::string report = folder_.path("report.json");
  const ToolRun run = grab({"--observations", "2", "--report", report}).succeeded();
  EXPECT_EQ(film_->mixed(), 0);
  EXPECT_THAT(run.err, HasSubstr("channels are reference,horizontal,vertical"));
  expectSameFiles(clouds_, trueClouds());

  const auto frames = framesOf(recorded_);
  const auto own = framesOf(truth());
  ASSERT_EQ(frames.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(frames[i]->number, own[i]->number);
    EXPECT_EQ(frames[i]->observation, own[i]->observation);
    EXPECT_EQ(frames[i]->pattern, own[i]->pattern);
    EXPECT_TRUE(frames[i]->images == own[i]->images) << i;
  }

  const auto json = jsonOfFile(report);
  EXPECT_EQ(json["camera"]["serial"], "00b09d0100c0ffee");
  EXPECT_EQ(json["camera"]["model"], "Emulated Digiclops");
  EXPECT_EQ(json["camera"]["lost"], 0);
  EXPECT_EQ(json["camera"]["order_check"]["is_certain"], true);
  EXPECT_EQ(json["projector"]["width"], screen_width);
  EXPECT_EQ(json["frames"], 2 * (patterns + 1));
  EXPECT_EQ(json["observations"].size(), 2u);
}

/** \brief Angle between two planes, degrees. */
double
angleBetween(const nlohmann::json& a, const nlohmann::json& b)
{
  double product = 0;
  for (std::size_t i = 0; i < 3; ++i)
    product += a[i].get<double>() * b[i].get<double>();
  return std::acos(std::min(1.0, std::abs(product))) * 180 / std::acos(-1.0);
}

TEST_F(DigiclopsCamera, PlanesOfTheMapAreThoseOfTheScene)
{
  grab().succeeded();
  const std::string map = folder_.path("map");
  runTool(ACMAP_COMPACT_MAPPING,
          {clouds_ + "/observation_0000.pcd", "-o", map, "--no-pictures"})
      .succeeded();
  const auto planes = jsonOfFile(map + "/map.json")["planes"];
  EXPECT_EQ(planes.size(), 3u);
  for (const TruthPlane& truth : planesInMap(*scene_)) {
    const Eigen::Vector4d& c = truth.coefficients;
    const nlohmann::json wanted = {c[0], c[1], c[2], c[3]};
    double angle = 90;
    double distance = 0;
    for (const auto& plane : planes)
      if (angleBetween(plane["coefficients"], wanted) < angle) {
        angle = angleBetween(plane["coefficients"], wanted);
        distance =
            std::abs(std::abs(plane["coefficients"][3].get<double>()) - std::abs(c[3]));
      }
    EXPECT_LT(angle, 1.0) << truth.name;
    EXPECT_LT(distance, 0.02) << truth.name;
    RecordProperty(truth.name + " off by degrees", std::to_string(angle));
    RecordProperty(truth.name + " off by metres", std::to_string(distance));
  }
}

TEST_F(DigiclopsCamera, AProjectorThatIsLateMixesPatternsUnlessItMaySettle)
{
  film_->linger();
  grab({"--settle", "0"}).succeeded();
  EXPECT_GT(film_->mixed(), 0);
  EXPECT_FALSE(contentOf(clouds_ + "/observation_0000.pcd") ==
               contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(DigiclopsCamera, TimeToSettleIsMeasured)
{
  projector_.setDelay(std::chrono::milliseconds(130)); // longer than the default
  const std::string report = folder_.path("report.json");
  const ToolRun run = grab({"--settle", "auto", "--report", report}).succeeded();
  EXPECT_THAT(run.err, HasSubstr("the projector settles in "));
  const auto json = jsonOfFile(report);
  EXPECT_GE(json["projector"]["settle"], 0.13);
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(DigiclopsCamera, ChannelsInAnotherOrderAreFound)
{
  const std::array<RigCamera, 3> usual = {
      RigCamera::Reference, RigCamera::Horizontal, RigCamera::Vertical};
  film_->setOrder({RigCamera::Vertical, RigCamera::Reference, RigCamera::Horizontal});
  const ToolRun run = grab();
  film_->setOrder(usual);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("channels are vertical,reference,horizontal"));
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(DigiclopsCamera, AnObservationMayEndEarly)
{
  film_->hang(); // a pattern that was shown before adds no information
  const std::string report = folder_.path("report.json");
  grab({"--early", "--report", report}).succeeded();
  const auto json = jsonOfFile(report);
  const int spared = json["projector"]["spared"];
  EXPECT_EQ(spared, 1); // three patterns are used before the need is judged
  EXPECT_EQ(json["frames"], patterns + 1 - spared);
  const std::string again = folder_.path("again");
  runTool(ACMAP_ACTIVE_STEREO, {recorded_, "-o", again}).succeeded();
  expectSameFiles(again, clouds_);
}

TEST_F(DigiclopsCamera, AWindowStaysUntilTheUserHasSeenEnough)
{
  // a display other than that of the projector
  const VirtualDisplay desk("1280x960x24");
  const std::string projector = screen_;
  RunSettings settings;
  settings.interrupt_when = [&] {
    return std::filesystem::exists(clouds_ + "/observation_0000.pcd");
  };
  settings.interrupt_after = 2; // seconds; the clouds are written before it waits
  const ToolRun run = grab({"--live", "--display", projector}, settings);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("close the window"));
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(DigiclopsCamera, WithoutAProjectorFramesAreStreamed)
{
  const std::vector<std::string> stream = {"--rig",
                                           truth() + "/rig.yaml",
                                           "-o",
                                           recorded_,
                                           "--patterns",
                                           "0",
                                           "--rate",
                                           "15"};
  std::vector<std::string> some = stream;
  some.insert(some.end(), {"--frames", "20"});
  const ToolRun run = runGrabber(some).succeeded();
  EXPECT_THAT(run.out, HasSubstr("20, rectified"));
  const auto frames = framesOf(recorded_);
  ASSERT_EQ(frames.size(), 20u);
  for (const TrinocularFrame::ConstPtr& frame : frames) {
    EXPECT_EQ(frame->pattern, TrinocularFrame::no_pattern);
    EXPECT_TRUE(frame->images == framesOf(truth())[0]->images);
  }
  std::filesystem::remove_all(recorded_);

  RunSettings interrupted; // an endless stream ends by an interruption
  interrupted.interrupt_when = [&] { return namesIn(recorded_).size() > 4; };
  EXPECT_EQ(runGrabber(stream, interrupted).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(recorded_ + "/session.yaml"));
  EXPECT_GE(framesOf(recorded_).size(), 3u);
}

} // namespace
} // namespace pcl::acmap::test
