#include "json_file.h"
#include "run_tool.h"
#include "simulated_runs.h"
#include "temporary_folder.h"

#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/core/trajectory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace pcl::acmap::test {
namespace {

using testing::HasSubstr;

/** A wall and a box in front of it, filmed from two positions. */
constexpr const char* small_room = R"(name: room
rig: {width: 64, height: 48, focal_length: 52, center_x: 31.5, center_y: 23.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 6, points: 1500}
looks:
  wall: {color: [150, 140, 130], texture: 2}
surfaces:
  - rectangle: {name: wall, corner: [-9, 9, 3], edges: [[18, 0, 0], [0, -18, 0]], look: wall}
  - box: {name: box, least: [-0.5, -0.5, 2], most: [0.5, 0.5, 2.5], look: wall}
path:
  - line: {from: [-0.5, 0, -0.5], to: [-0.5, 0, 1], views: 2}
)";

class SimulatedSession : public testing::Test {
protected:
  ToolRun
  film(const std::vector<std::string>& more = {}, const RunSettings& settings = {})
  {
    return runTool(ACMAP_SIMULATED_RIG,
                   joined({"-o", session_, "--scene", scene_}, more),
                   settings);
  }

  std::string
  inSession(const std::string& name) const
  {
    return session_ + "/" + name;
  }

  TemporaryFolder folder_;
  std::string scene_ = folder_.write("room.yaml", small_room);
  std::string session_ = folder_.path("session");
};

TEST_F(SimulatedSession, HoldsAllShots)
{
  const ToolRun run = film({"--patterns", "2"}).succeeded();
  EXPECT_THAT(run.out, HasSubstr("frames:      6"));
  const auto frames = framesOf(session_);
  ASSERT_EQ(frames.size(), 6u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i]->number, i);
    EXPECT_EQ(frames[i]->observation, static_cast<int>(i / 3));
    EXPECT_EQ(frames[i]->pattern, static_cast<int>(i % 3) - 1);
    for (const CameraImage& image : frames[i]->images) {
      ASSERT_EQ(image.values.size(), 3u * 64u * 48u);
      const double off = meanOf(frames[3 * (i / 3)]->images[0]);
      EXPECT_EQ(meanOf(image) > 1.1 * off, i % 3 != 0);
    }
  }
}

/** Section II-A: N = 10, L = 200, 14 frames a second. */
TEST_F(SimulatedSession, IsAsThePaperTakesItByDefault)
{
  film().succeeded();
  const auto frames = framesOf(session_);
  constexpr std::size_t shots = 11; // one without a pattern
  ASSERT_EQ(frames.size(), 2 * shots);
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(frames[i]->pattern, static_cast<int>(i % shots) - 1);
  for (std::size_t i = 1; i < shots; ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(frames[i]->images[0].values, frames[k]->images[0].values);
  EXPECT_NEAR(
      loadTrajectory(inSession("trajectory.txt")).stamps[1], shots / 14.0, 1e-9);
  EXPECT_EQ(jsonOfFile(inSession("truth.json"))["lines"], 200);
}

TEST_F(SimulatedSession, HoldsTheTruth)
{
  film({"--patterns", "1", "--seed", "4"}).succeeded();
  const Trajectory trajectory = loadTrajectory(inSession("trajectory.txt"));
  ASSERT_EQ(trajectory.poses.size(), 2u);
  // of the first shot of the observation
  EXPECT_NEAR(trajectory.stamps[1], 2.0 / 14.0, 1e-9);
  EXPECT_NEAR(trajectory.poses[1].translation().z(), 1.5, 1e-9);
  const DisparityImage first = loadPfm(inSession("disparity_0000.pfm"));
  ASSERT_EQ(first.width, 64);
  EXPECT_FLOAT_EQ(first.at(0, 0), 52 * 0.1 / 3.5);   // the wall
  EXPECT_FLOAT_EQ(first.at(42, 24), 52 * 0.1 / 2.5); // the box
  EXPECT_FLOAT_EQ(loadPfm(inSession("disparity_0001.pfm")).at(0, 0), 52 * 0.1 / 2.0);
  const GrayImage16 visible = loadGrayImage16(inSession("visible_0000.png"));
  // both neighbours and the projector see it
  EXPECT_EQ(visible.values[24 * 64 + 42], 7);
  EXPECT_EQ(visible.values[24 * 64 + 63] & 1, 0); // beyond the border of the left one
  const auto truth = jsonOfFile(inSession("truth.json"));
  EXPECT_EQ(truth["scene"], "room");
  EXPECT_EQ(truth["seed"], 4);
  EXPECT_EQ(truth["patterns"], 1);
  EXPECT_EQ(truth["observations"], 2);
  EXPECT_EQ(truth["planes"].size(), 7u);
}

TEST_F(SimulatedSession, HasTheLinesAndTheApertureThatAreAsked)
{
  film({"--patterns", "1", "--lines", "30", "--aperture", "0"}).succeeded();
  const auto truth = jsonOfFile(inSession("truth.json"));
  EXPECT_EQ(truth["lines"], 30);
  EXPECT_EQ(truth["light"]["aperture"], 0);
  const GrayImage16 visible = loadGrayImage16(inSession("visible_0000.png"));
  EXPECT_EQ(visible.values[24 * 64 + 42], 3) << "of the cameras, not of the projector";
  expectFails(film({"--lines", "0"}), 2, "lines");
}

/** The number of measurable points in the session's files is that of its planes. */
TEST_F(SimulatedSession, CountsWhatCanBeMeasuredOfEachPlane)
{
  film({"--patterns", "1"}).succeeded();
  std::size_t wall = 0, box = 0;
  for (const std::string number : {"0000", "0001"}) {
    const DisparityImage disparities =
        loadPfm(inSession("disparity_" + number + ".pfm"));
    const GrayImage16 visible =
        loadGrayImage16(inSession("visible_" + number + ".png"));
    const float wall_disparity = disparities.at(0, 0);
    for (std::size_t i = 0; i < visible.values.size(); ++i) {
      const bool is_measurable = (visible.values[i] & 3) != 0 && visible.values[i] >= 4;
      wall += is_measurable && disparities.values[i] == wall_disparity;
      box += is_measurable && disparities.values[i] > wall_disparity;
    }
  }
  const auto truth = jsonOfFile(inSession("truth.json"));
  ASSERT_EQ(truth["planes"][0]["name"], "wall");
  EXPECT_EQ(truth["planes"][0]["points"], wall);
  EXPECT_GT(box, 0u);
  std::size_t others = 0;
  for (std::size_t i = 1; i < truth["planes"].size(); ++i)
    others += truth["planes"][i]["points"].get<std::size_t>();
  EXPECT_EQ(others, box);
  EXPECT_EQ(truth["points"], wall + box);
}

/** Points that are too near, or too far away, are not measured. */
TEST_F(SimulatedSession, CountsNothingBeyondTheRangeOfStereo)
{
  std::string text = small_room;
  for (const auto& [before, after] :
       {std::pair{"corner: [-9, 9, 3]", "corner: [-9, 9, 9.8]"},
        std::pair{"least: [-0.5, -0.5, 2]", "least: [-0.5, -0.5, -0.05]"},
        std::pair{"most: [0.5, 0.5, 2.5]", "most: [0.5, 0.5, -0.01]"},
        std::pair{"to: [-0.5, 0, 1], views: 2", "to: [-0.5, 0, 0], views: 2"}})
    text.replace(text.find(before), std::string(before).size(), after);
  scene_ = folder_.write("room.yaml", text);
  film({"--patterns", "1"}).succeeded();
  const auto truth = jsonOfFile(inSession("truth.json"));
  const DisparityImage second = loadPfm(inSession("disparity_0001.pfm"));
  std::size_t box = 0;
  for (const auto& plane : truth["planes"])
    if (plane["name"] != "wall")
      box += plane["points"].get<std::size_t>();
  EXPECT_FLOAT_EQ(second.at(0, 0), 52 * 0.1 / 9.8);
  EXPECT_GT(truth["planes"][0]["points"],
            0); // from the second position; 10.3 m is too far
  EXPECT_LT(truth["planes"][0]["points"], 64 * 48);
  // the box is in front of the first position, behind the second one
  EXPECT_EQ(box, 0u);
}

TEST_F(SimulatedSession, AnotherSeedIsAnotherSession)
{
  const auto bytes = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = joined({"--patterns", "1"}, more);
    EXPECT_EQ(film(all).exit_code, 0);
    std::string content;
    for (const TrinocularFrame::ConstPtr& frame : framesOf(session_))
      for (const CameraImage& image : frame->images)
        content.append(image.values.begin(), image.values.end());
    for (const char* name : {"disparity_0001.pfm", "visible_0001.png", "truth.json"})
      content += contentOf(inSession(name));
    std::filesystem::remove_all(session_);
    return content;
  };
  EXPECT_NE(bytes({"--seed", "2"}), bytes({}));
}

TEST_F(SimulatedSession, OtherSessionsStay)
{
  film({"--patterns", "1"}).succeeded();
  const std::string before = contentOf(inSession("session.yaml"));
  const ToolRun again = film();
  EXPECT_EQ(again.exit_code, 5);
  EXPECT_THAT(again.err, HasSubstr("already holds"));
  EXPECT_EQ(contentOf(inSession("session.yaml")), before);
  EXPECT_EQ(film({"--clouds"}).exit_code, 5);
}

TEST_F(SimulatedSession, WhatFailsLeavesNothing)
{
  RunSettings full;
  full.file_size_limit = 5000;
  EXPECT_EQ(film({}, full).exit_code, 5);
  std::string text = small_room;
  text.replace(text.find("from: [-0.5, 0, -0.5]"), 21, "from: [-0.5, 0, 99.0]");
  text.replace(text.find("to: [-0.5, 0, 1]"), 16, "to: [-0.5, 0, 100]");
  scene_ = folder_.write("room.yaml", text);
  const ToolRun nothing = film({"--patterns", "1"});
  EXPECT_EQ(nothing.exit_code, 4) << nothing.err;
  scene_ = "corridor";
  RunSettings interrupted;
  interrupted.interrupt_after = 1.0;
  EXPECT_EQ(film({}, interrupted).exit_code, 130);
  EXPECT_EQ(folder_.count(), 1);
}

} // namespace
} // namespace pcl::acmap::test
