#include "sgbm_disparity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace pcl::acmap::bench {

namespace {

cv::Mat
greyOf(const CameraImage& image)
{
  const cv::Mat values(image.height,
                       image.width,
                       CV_8UC(image.channels),
                       const_cast<std::uint8_t*>(image.values.data()));
  if (image.channels == 1)
    return values;
  cv::Mat grey;
  cv::cvtColor(values, grey, cv::COLOR_RGB2GRAY);
  return grey;
}

cv::Mat
mirroredOf(const cv::Mat& image)
{
  cv::Mat other;
  cv::flip(image, other, 1);
  return other;
}

/** Adds constant columns on the left. */
cv::Mat
widened(const cv::Mat& image, int columns)
{
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, 0, columns, 0, cv::BORDER_REFLECT);
  return wide;
}

cv::Ptr<cv::StereoSGBM>
matcherOf(const SgbmSetting& setting)
{
  constexpr int small_step = 8, large_step = 32; // penalties of OpenCV's samples
  constexpr int uniqueness = 5, speckle_size = 100, speckle_range = 2, check = 1;
  constexpr int block = 5, area = block * block;
  const auto matcher = cv::StereoSGBM::create(setting.minimum,
                                              setting.disparities,
                                              block,
                                              small_step * area,
                                              large_step * area);
  matcher->setPreFilterCap(setting.prefilter);
  if (setting.filters) {
    matcher->setDisp12MaxDiff(check);
    matcher->setUniquenessRatio(uniqueness);
    matcher->setSpeckleWindowSize(speckle_size);
    matcher->setSpeckleRange(speckle_range);
  }
  else
    matcher->setDisp12MaxDiff(-1);
  return matcher;
}

DisparityImage
inPixels(const cv::Mat& steps, int minimum)
{
  DisparityImage image{steps.cols, steps.rows, {}};
  image.values.reserve(steps.total());
  constexpr int scale = cv::StereoMatcher::DISP_SCALE;
  for (const short value : cv::Mat_<short>(steps))
    image.values.push_back(value >= minimum * scale
                               ? static_cast<float>(value) / scale
                               : std::numeric_limits<float>::quiet_NaN());
  return image;
}

} // namespace

DisparityImage
sgbmDisparity(const TrinocularFrame& frame,
              const TrinocularRig& rig,
              const SgbmSetting& setting)
{
  cv::Mat reference = greyOf(frame.image(RigCamera::Reference));
  cv::Mat neighbour = greyOf(frame.image(RigCamera::Horizontal));
  const bool mirrored =
      rig.baseline_horizontal < 0; // SGBM uses the left image as reference
  if (mirrored) {
    reference = mirroredOf(reference);
    neighbour = mirroredOf(neighbour);
  }
  const int more = setting.padded ? setting.minimum + setting.disparities : 0;
  cv::Mat steps;
  matcherOf(setting)->compute(
      widened(reference, more), widened(neighbour, more), steps);
  steps = steps.colRange(more, steps.cols);
  return inPixels(mirrored ? mirroredOf(steps) : steps, setting.minimum);
}

std::vector<DisparityImage>
sgbmDisparities(const std::vector<TrinocularFrame::ConstPtr>& frames,
                const TrinocularRig& rig,
                const SgbmSetting& setting)
{
  std::vector<DisparityImage> images;
  for (const TrinocularFrame::ConstPtr& frame : frames)
    images.push_back(sgbmDisparity(*frame, rig, setting));
  return images;
}

DisparityImage
medianDisparity(const std::vector<DisparityImage>& images)
{
  constexpr std::size_t min_support = 3;
  DisparityImage fused = images.front();
  std::vector<float> found;
  for (std::size_t i = 0; i < fused.values.size(); ++i) {
    found.clear();
    for (const DisparityImage& image : images)
      if (!std::isnan(image.values[i]))
        found.push_back(image.values[i]);
    std::sort(found.begin(), found.end());
    fused.values[i] = found.size() >= min_support
                          ? found[(found.size() - 1) / 2]
                          : std::numeric_limits<float>::quiet_NaN();
  }
  return fused;
}

} // namespace pcl::acmap::bench
