#include "stereo_input.h"

#include "test_data.h"

#include <pcl/core/image_file.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
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

bool
hasAllData(const char* section, const std::vector<std::string>& files)
{
  for (const std::string& file : files)
    if (!test::hasTestData(file)) {
      std::cout << "\n" << section << ": left out, no " << file << "\n";
      return false;
    }
  return true;
}

} // namespace pcl::acmap::bench
