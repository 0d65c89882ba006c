#include "digiclops_camera_runs.h"
#include "iidc_addresses.h"
#include "json_file.h"
#include "simulated_runs.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace pcl::acmap::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using DigiclopsCameraFaults = DigiclopsCameraRuns;

CameraOptions
secondCamera()
{
  CameraOptions options;
  options.identity.guid = 0x00B09D0100ABCDEF;
  options.identity.model = "Second";
  return options;
}

TEST_F(DigiclopsCameraFaults, UnpluggedItKeepsTheObservationsBefore)
{
  // one shot for the order of the channels, one observation, and a part of another one
  camera_.faults().failFrame(FrameFault::Unplug, 1 + (patterns + 1) + 2);
  const ToolRun run = grab({"--observations", "2"});
  expectFails(run, 1, "observations finished by then, in " + clouds_ + ": 1;");
  EXPECT_THAT(run.err, HasSubstr("frames recorded by then, in " + recorded_ + ": 5\n"));
  EXPECT_THAT(namesIn(clouds_), ElementsAre("observation_0000.pcd"));
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
  EXPECT_EQ(framesOf(recorded_).size(), 5u);
}

TEST_F(DigiclopsCameraFaults, UnpluggedItLeavesTheMapOfTheObservationsBefore)
{
  camera_.faults().failFrame(FrameFault::Unplug, 1 + (patterns + 1) + 2);
  const std::string map = folder_.path("map");
  const ToolRun run = runGrabber({"--rig",
                                  truth() + "/rig.yaml",
                                  "--map",
                                  map,
                                  "--patterns",
                                  std::to_string(patterns),
                                  "--shutter",
                                  "0.01",
                                  "--observations",
                                  "2"});
  expectFails(run, 1, "the map of the 1 observation by then is in " + map);
  const auto planes = jsonOfFile(map + "/map.json")["planes"];
  EXPECT_EQ(planes.size(), 3u);
}

TEST_F(DigiclopsCameraFaults, UnpluggedAtOnceItLeavesNothing)
{
  camera_.faults().failFrame(FrameFault::Unplug, 2);
  expectFails(grab(), 1, "unplugged");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(DigiclopsCameraFaults, SilenceIsTold)
{
  camera_.faults().setSilent(true);
  expectFails(grab(), 1, "no frame came");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(DigiclopsCameraFaults, CamerasAreListedAndToldApart)
{
  EmulatedIidcCamera camera([](const Exposure& e) { return film_->expose(e); },
                            secondCamera());
  camera.faults().overrideRegister(iidc::frame_info, 0);
  const EmulatedUsbCamera cable(testbed_, camera);
  const std::string report = folder_.path("report.json");
  const ToolRun list = runGrabber({"--list", "--report", report}).succeeded();
  EXPECT_EQ(list.err, "");
  EXPECT_THAT(list.out, HasSubstr("1:" + std::to_string(cable_.address()) + ":"));
  EXPECT_THAT(list.out, HasSubstr("00b09d0100c0ffee, Point Grey Research, Emulated"));
  EXPECT_THAT(list.out, HasSubstr("00b09d0100abcdef, Point Grey Research, Second"));
  EXPECT_THAT(list.out, HasSubstr("480 Mb/s"));
  EXPECT_EQ(jsonOfFile(report)["cameras"].size(), 2u);

  const std::string second = "1:" + std::to_string(cable.address());
  for (const std::string& device : {std::string("00b09d0100abcdef"), second}) {
    grab({"--device", device, "--report", report}).succeeded();
    EXPECT_EQ(jsonOfFile(report)["camera"]["model"], "Second");
    fs::remove_all(clouds_);
    fs::remove_all(recorded_);
    film_->watch(projector_);
  }
}

TEST_F(DigiclopsCameraFaults, WithoutPermissionTheRuleIsTold)
{
  cable_.setPermission(false);
  expectFails(grab(), 1, "udev");
  EXPECT_EQ(folder_.count(), 0);
  const ToolRun list = runGrabber({"--list"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.out, HasSubstr("1e10:2000, permission denied"));
}

TEST_F(DigiclopsCameraFaults, WithoutACameraThereIsNothing)
{
  cable_.unplug();
  expectFails(grab(), 4, "camera");
  expectFails(grab({"--device", "00b09d0100c0ffee"}), 4, "00b09d0100c0ffee");
  expectFails(runGrabber({"--list"}), 4, "camera");
  EXPECT_EQ(folder_.count(), 0);
  expectFails(grab({"--device", "somewhere"}), 2, "somewhere");
}

TEST_F(DigiclopsCameraFaults, WhatTheCameraCannotDoIsRefused)
{
  expectFails(grab({"--mode", "7:6"}), 2, "7:0 640x480 RGB8");
  expectFails(grab({"--mode", "7:3"}), 2, "mode");
  expectFails(grab({"--shutter", "50"}), 2, "shutter");
  expectFails(grab({"--monitor", "3"}), 2, "monitor");
  expectFails(grab({"--display", ":4711"}), 1, ":4711");
  EXPECT_EQ(folder_.count(), 0);
}

TEST_F(DigiclopsCameraFaults, InterruptedItKeepsWholeObservations)
{
  RunSettings settings;
  settings.interrupt_when = [&] { return namesIn(recorded_).size() > 8; };
  const ToolRun run = grab({"--observations", "100"}, settings);
  expectFails(run, 130, "interrupted; observations finished by then");
  const std::size_t clouds = namesIn(clouds_).size();
  EXPECT_GE(clouds, 1u);
  EXPECT_LT(clouds, 100u);
  EXPECT_EQ(framesOf(recorded_).size() % (patterns + 1), 0u);
  EXPECT_TRUE(contentOf(clouds_ + "/observation_0000.pcd") ==
              contentOf(trueClouds() + "/observation_0000.pcd"));
}

TEST_F(DigiclopsCameraFaults, AClockMayBeginObservations)
{
  const auto begin = std::chrono::steady_clock::now();
  grab({"--observations", "2", "--every", "4"}).succeeded();
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::seconds(4));
  expectSameFiles(clouds_, trueClouds());
}

} // namespace
} // namespace pcl::acmap::test
