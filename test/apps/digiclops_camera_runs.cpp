#include "digiclops_camera_runs.h"

#include "iidc_addresses.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/simulation/scene_file.h>

#include <cstdlib>

namespace pcl::acmap::test {

namespace {

constexpr const char* corner = R"(name: corner
sensor: {reach: 6, points: 1500}
looks:
  wall: {color: [170, 168, 162], texture: 2}
  floor: {color: [128, 122, 114], texture: 4}
surfaces:
  - rectangle: {name: floor, corner: [-3, 0.8, -1], edges: [[6, 0, 0], [0, 0, 5]], look: floor}
  - rectangle: {name: left wall, corner: [-1.2, 0.8, -1], edges: [[0, 0, 5], [0, -3, 0]], look: wall}
  - rectangle: {name: far wall, corner: [-3, 0.8, 2.6], edges: [[6, 0, 0], [0, -3, 0]], look: wall}
path:
  - line: {from: [0, 0, 0], to: [0, 0, 0.1], views: 2, yaw: [-12, -8]}
)";

} // namespace

TemporaryFolder* DigiclopsCameraRuns::folders_ = nullptr;
VirtualDisplay* DigiclopsCameraRuns::display_ = nullptr;
std::string DigiclopsCameraRuns::screen_;
SimulatedScene* DigiclopsCameraRuns::scene_ = nullptr;
std::vector<RgbImage> DigiclopsCameraRuns::lights_;
FilmedByCamera* DigiclopsCameraRuns::film_ = nullptr;

void
DigiclopsCameraRuns::SetUpTestSuite()
{
  folders_ = new TemporaryFolder;
  display_ = new VirtualDisplay(std::to_string(screen_width) + "x" +
                                std::to_string(screen_height) + "x24");
  if (!display_->exists())
    return;
  screen_ = std::getenv("DISPLAY");
  RandomLinePattern lines;
  lines.setSize(screen_width, screen_height);
  for (std::uint32_t i = 0; i < patterns; ++i)
    lights_.push_back(lines.generate(i));
  RgbImage white = lights_.front();
  white.values.assign(white.values.size(), 255);
  lights_.push_back(white);
  scene_ =
      new SimulatedScene(loadSimulatedScene(folders_->write("corner.yaml", corner)));
  film_ = new FilmedByCamera(*scene_, lights_);
  film_->record(truth());
  runTool(ACMAP_ACTIVE_STEREO, {truth(), "-o", trueClouds()}).succeeded();
}

void
DigiclopsCameraRuns::TearDownTestSuite()
{
  delete film_;
  film_ = nullptr;
  delete scene_;
  scene_ = nullptr;
  delete display_;
  delete folders_;
  lights_.clear();
}

CameraOptions
DigiclopsCameraRuns::usualCamera()
{
  return {};
}

void
DigiclopsCameraRuns::SetUp()
{
  if (!film_)
    GTEST_SKIP() << "no X server for the projector";
  film_->watch(projector_);
  // the camera does not write frame numbers into the first pixels
  camera_.faults().overrideRegister(iidc::frame_info, 0);
}

ToolRun
DigiclopsCameraRuns::grab(const std::vector<std::string>& more,
                          const RunSettings& settings) const
{
  return runGrabber(joined({"--rig",
                            truth() + "/rig.yaml",
                            "--pcd",
                            clouds_,
                            "-o",
                            recorded_,
                            "--patterns",
                            std::to_string(patterns),
                            "--shutter",
                            "0.01"},
                           more),
                    settings);
}

} // namespace pcl::acmap::test
