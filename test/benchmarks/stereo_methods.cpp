#include "stereo_methods.h"

#include "bench.h"

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

namespace {

/** Calls a function with index and signed error of each pixel of a mask with a
 * disparity. */
template <typename Function>
void
forEachError(const DisparityImage& found,
             const DisparityImage& truth,
             const PixelMask& mask,
             const Function& function)
{
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i] != 0 && !std::isnan(found.values[i]))
      function(i, static_cast<double>(found.values[i]) - truth.values[i]);
}

bool
isBad(double error)
{
  return std::abs(error) > DisparityErrors::bad_error;
}

double
deviation(const std::vector<double>& values)
{
  const double middle = meanOf(values);
  return std::sqrt(
      meanOf(valuesOf(values, [&](double v) { return (v - middle) * (v - middle); })));
}

} // namespace

void
DisparityErrors::add(const DisparityImage& found,
                     const DisparityImage& truth,
                     const PixelMask& mask)
{
  for (const std::uint8_t flag : mask)
    judged_ += flag != 0 ? 1 : 0;
  forEachError(found, truth, mask, [&](std::size_t, double error) {
    errors_.push_back(std::abs(error));
    wrong_ += isBad(error) ? 1 : 0;
  });
}

double
DisparityErrors::bad() const
{
  return percent(judged_ - errors_.size() + wrong_, judged_);
}

double
DisparityErrors::present() const
{
  return percent(errors_.size(), judged_);
}

double
DisparityErrors::wrong() const
{
  return percent(wrong_, judged_);
}

double
DisparityErrors::medianError() const
{
  return median(errors_);
}

double
DisparityErrors::rms() const
{
  double squares = 0;
  for (const double error : errors_)
    squares += isBad(error) ? 0 : error * error;
  return std::sqrt(squares / static_cast<double>(errors_.size() - wrong_));
}

void
FractionErrors::add(const DisparityImage& found,
                    const DisparityImage& truth,
                    const PixelMask& mask)
{
  forEachError(found, truth, mask, [&](std::size_t i, double error) {
    if (isBad(error))
      return;
    const double disparity = truth.values[i];
    const double fraction = disparity - std::floor(disparity);
    errors_[static_cast<std::size_t>(fraction * bins) % bins].push_back(error);
  });
}

double
FractionErrors::lockingOfMeans() const
{
  return deviation(valuesOf(errors_, [](auto& errors) { return meanOf(errors); }));
}

double
FractionErrors::lockingOfMedians() const
{
  return deviation(valuesOf(errors_, [](auto& errors) { return median(errors); }));
}

void
SigmaErrors::add(const DisparityImage& found,
                 const std::vector<float>& sigma,
                 const DisparityImage& truth,
                 const PixelMask& mask)
{
  forEachError(found, truth, mask, [&](std::size_t i, double error) {
    if (isBad(error))
      return;
    ++count_;
    sigmas_ += sigma[i];
    squares_ += error * error / (static_cast<double>(sigma[i]) * sigma[i]);
  });
}

double
SigmaErrors::ratio() const
{
  return std::sqrt(squares_ / static_cast<double>(count_));
}

double
SigmaErrors::meanSigma() const
{
  return sigmas_ / static_cast<double>(count_);
}

MatchedDisparity
fusedDisparity(const StereoShots& shots,
               DisparityFusion::Method method,
               const TrinocularMatching& matching)
{
  DisparityFusion fusion;
  fusion.setMatching(matching);
  fusion.setMethod(method);
  fusion.setInputRig(shots.rig);
  for (const TrinocularFrame::ConstPtr& frame : shots.frames)
    fusion.addShot(frame);
  MatchedDisparity fused;
  fusion.fuse(fused);
  return fused;
}

Eigen::Vector3d
pointOf(const TrinocularRig& rig, std::size_t pixel, double disparity)
{
  const auto width = static_cast<std::size_t>(rig.width);
  const double depth = rig.focal_length * disparityBaseline(rig) / disparity;
  return depth *
         Eigen::Vector3d(
             (static_cast<double>(pixel % width) - rig.center_x) / rig.focal_length,
             (static_cast<double>(pixel / width) - rig.center_y) / rig.focal_length,
             1.0);
}

} // namespace pcl::acmap::bench
