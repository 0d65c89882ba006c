#include "active_stereo_runs.h"

#include "simulated_runs.h"

#include <pcl/io/pcd_io.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap::test {

namespace {

constexpr const char* room = R"(name: room
rig: {width: 160, height: 120, focal_length: 130, center_x: 79.5, center_y: 59.5,
      baseline_horizontal: -0.1, baseline_vertical: -0.1, disparity_sigma: 0.13}
sensor: {reach: 6, points: 1500}
looks:
  wall: {color: [150, 140, 130], texture: 2}
surfaces:
  - rectangle: {name: wall, corner: [-9, 9, 2], edges: [[18, 0, 1], [0, -18, 0]], look: wall}
  - box: {name: box, least: [-0.4, -0.4, 1.6], most: [0.4, 0.4, 2], look: wall}
path:
  - line: {from: [-0.2, 0, -0.2], to: [-0.1, 0.1, 0], views: 2, yaw: [8, -10]}
)";

std::string
pngOf(const CameraImage& image)
{
  const std::vector<std::uint8_t> bytes =
      encodePng(RgbImage{image.width, image.height, image.values});
  return {bytes.begin(), bytes.end()};
}

} // namespace

StereoFile
loadStereo(const std::string& path)
{
  StereoFile file;
  PCLPointCloud2 blob;
  EXPECT_EQ(io::loadPCDFile(path, blob, file.origin, file.orientation), 0) << path;
  fromPCLPointCloud2(blob, file.cloud);
  return file;
}

TruthFit
fitOf(const DisparityImage& disparity, const std::string& session, int observation)
{
  const std::string number = "000" + std::to_string(observation);
  const DisparityImage truth = loadPfm(session + "/disparity_" + number + ".pfm");
  const GrayImage16 visible = loadGrayImage16(session + "/visible_" + number + ".png");
  EXPECT_EQ(disparity.values.size(), truth.values.size());
  std::vector<double> off;
  std::size_t lit = 0;
  for (std::size_t i = 0; i < truth.values.size(); ++i) {
    if (visible.values[i] != 7)
      continue;
    ++lit;
    if (std::isfinite(disparity.values[i]))
      off.push_back(std::abs(disparity.values[i] - truth.values[i]));
  }
  TruthFit fit;
  if (off.empty())
    return fit;
  std::sort(off.begin(), off.end());
  fit.found = static_cast<double>(off.size()) / static_cast<double>(lit);
  fit.wrong =
      static_cast<double>(off.end() - std::upper_bound(off.begin(), off.end(), 1.0)) /
      static_cast<double>(off.size());
  fit.median = off[off.size() / 2];
  return fit;
}

DisparityImage
disparityOf(const StereoCloud& cloud, const TrinocularRig& rig)
{
  DisparityImage disparity;
  disparity.width = static_cast<std::int32_t>(cloud.width);
  disparity.height = static_cast<std::int32_t>(cloud.height);
  for (const PointXYZRGBSigma& point : cloud)
    disparity.values.push_back(static_cast<float>(
        rig.focal_length * std::abs(rig.baseline_horizontal) / point.z));
  return disparity;
}

std::array<std::vector<std::string>, 3>
writeImages(const std::string& session, const TemporaryFolder& folder)
{
  std::array<std::vector<std::string>, 3> paths;
  for (const TrinocularFrame::ConstPtr& frame : framesOf(session)) {
    if (frame->observation != 0)
      continue;
    if (frame->pattern == TrinocularFrame::no_pattern)
      folder.write("off.png", pngOf(frame->images[0]));
    else
      for (std::size_t i = 0; i < paths.size(); ++i)
        paths[i].push_back(folder.write(nameOf(static_cast<RigCamera>(i)) +
                                            std::to_string(frame->pattern) + ".png",
                                        pngOf(frame->images[i])));
  }
  return paths;
}

TemporaryFolder* ActiveStereoRuns::filmed_ = nullptr;
std::array<std::vector<std::string>, 3> ActiveStereoRuns::listed_;

void
ActiveStereoRuns::SetUpTestSuite()
{
  filmed_ = new TemporaryFolder;
  runTool(ACMAP_SIMULATED_RIG,
          {"-o",
           session(),
           "--scene",
           filmed_->write("room.yaml", room),
           "--patterns",
           "6",
           "--projector-power",
           "4",
           "--exposure",
           "0.7"})
      .succeeded();
  listed_ = writeImages(session(), *filmed_);
}

void
ActiveStereoRuns::TearDownTestSuite()
{
  delete filmed_;
  filmed_ = nullptr;
}

ToolRun
ActiveStereoRuns::runSession(const std::vector<std::string>& more,
                             const RunSettings& settings) const
{
  return runTool(ACMAP_ACTIVE_STEREO, joined({input_, "-o", out_}, more), settings);
}

ToolRun
ActiveStereoRuns::runLists(const std::vector<std::string>& more,
                           const RunSettings& settings) const
{
  std::vector<std::string> all = {"-o", out_, "--rig", rig_};
  for (std::size_t i = 0; i < images_.size(); ++i) {
    if (images_[i].empty())
      continue;
    all.push_back(std::string("--") + nameOf(static_cast<RigCamera>(i)));
    all.insert(all.end(), images_[i].begin(), images_[i].end());
  }
  all.insert(all.end(), more.begin(), more.end());
  return runTool(ACMAP_ACTIVE_STEREO, all, settings);
}

void
ActiveStereoRuns::expectRefused(const ToolRun& run,
                                int exit_code,
                                const std::string& word) const
{
  test::expectRefused(run, exit_code, word);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

} // namespace pcl::acmap::test
