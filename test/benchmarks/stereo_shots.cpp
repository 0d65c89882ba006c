#include "stereo_shots.h"

#include "bench.h"
#include "paper_patterns.h"
#include "test_data.h"

#include <pcl/core/image_file.h>
#include <pcl/simulation/simulated_rig_grabber.h>

#include <opencv2/imgproc.hpp>

namespace pcl::acmap::bench {

StereoShots
binocularShots(int width, int height, double focal_length, double baseline)
{
  StereoShots shots;
  shots.rig.width = width;
  shots.rig.height = height;
  shots.rig.focal_length = focal_length;
  shots.rig.center_x = 0.5 * (width - 1);
  shots.rig.center_y = 0.5 * (height - 1);
  shots.rig.baseline_horizontal = baseline;
  shots.rig.baseline_vertical = 0;
  return shots;
}

TrinocularFrame::ConstPtr
frameOf(CameraImage reference, CameraImage horizontal, std::int32_t pattern)
{
  TrinocularFrame frame;
  frame.number = static_cast<std::uint64_t>(std::max(pattern, 0));
  frame.pattern = pattern;
  frame.image(RigCamera::Reference) = std::move(reference);
  frame.image(RigCamera::Horizontal) = std::move(horizontal);
  return make_shared<TrinocularFrame>(std::move(frame));
}

CameraImage
loadGreyImage(const std::string& relative)
{
  CameraImage image = loadCameraImage(test::testDataPath(relative).string());
  const cv::Mat color(image.height, image.width, CV_8UC3, image.values.data());
  cv::Mat grey;
  cv::cvtColor(color, grey, cv::COLOR_RGB2GRAY);
  return {image.width, image.height, 1, {grey.begin<uchar>(), grey.end<uchar>()}};
}

DisparityImage
loadPngDisparity(const std::string& relative, double steps)
{
  const GrayImage16 stored = loadGrayImage16(test::testDataPath(relative).string());
  DisparityImage truth{stored.width, stored.height, {}};
  for (const std::uint16_t value : stored.values)
    truth.values.push_back(value > 0 ? static_cast<float>(value / steps)
                                     : std::numeric_limits<float>::quiet_NaN());
  return truth;
}

PixelMask
pixelsWithTruth(const DisparityImage& truth)
{
  PixelMask mask;
  for (const float disparity : truth.values)
    mask.push_back(std::isnan(disparity) ? 0 : 1);
  return mask;
}

namespace {

/** Two colours with hardly any grain, on which stereo finds nothing without
 * patterns. */
constexpr SurfaceLook wall_look{{168, 166, 160}, 2.0};
constexpr SurfaceLook box_look{{142, 150, 160}, 2.0};

void
addWall(SimulatedScene& scene)
{
  scene.geometry.addRectangle(
      "wall", "wall", {{-8, 4, 3}, {16, 0, 0}, {0, -8, 0}}, wall_look);
}

/** Pose of a camera that looks at the wall obliquely. */
Eigen::Isometry3d
lookFrom(double x, double y, double yaw, double pitch)
{
  return Eigen::Translation3d(x, y, 0) *
         Eigen::AngleAxisd(yaw * degree, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(pitch * degree, Eigen::Vector3d::UnitX());
}

} // namespace

SimulatedScene
wallWithBox()
{
  SimulatedScene scene;
  scene.name = "wall with a box";
  addWall(scene);
  scene.geometry.addBox("box", {-0.25, -0.25, 1.5}, {0.25, 0.25, 2.0}, box_look);
  scene.views = {lookFrom(0.5, 0.1, -14, 4), lookFrom(-0.7, -0.1, 17, -5)};
  return scene;
}

SimulatedScene
slantedWall()
{
  SimulatedScene scene;
  scene.name = "slanted wall";
  addWall(scene);
  scene.views = {lookFrom(0, 0, 27, 8)};
  return scene;
}

SimulatedShots
takeShots(const SimulatedScene& scene, std::size_t view)
{
  const SimulatedRigGrabber grabber(scene, drawPatterns());
  SimulatedShots taken;
  taken.shots.rig = scene.rig;
  for (const TrinocularFrame::Ptr& frame : grabber.observe(view))
    if (frame->pattern == TrinocularFrame::no_pattern)
      taken.off = frame;
    else
      taken.shots.frames.push_back(frame);
  taken.truth = truthOf(scene, view);
  taken.shots.truth = taken.truth.horizontal;
  return taken;
}

StereoShots
withoutVertical(const StereoShots& shots)
{
  StereoShots two = shots;
  two.rig.baseline_vertical = 0;
  for (TrinocularFrame::ConstPtr& frame : two.frames) {
    TrinocularFrame pair = *frame;
    pair.image(RigCamera::Vertical) = {};
    frame = make_shared<TrinocularFrame>(std::move(pair));
  }
  return two;
}

} // namespace pcl::acmap::bench
