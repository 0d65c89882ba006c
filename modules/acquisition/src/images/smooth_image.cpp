#include "smooth_image.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr double patch_blur = 1.0;   // standard deviation, px
constexpr double corner_blur = 2.0;  // standard deviation, px
constexpr double min_contrast = 2.0; // standard deviation, grey levels

cv::Mat
greyOf(const CameraImage& image)
{
  // OpenCV has no matrix of constant data; this one is only read.
  auto* const values = const_cast<std::uint8_t*>(image.values.data());
  const cv::Mat all(image.height, image.width, CV_8UC(image.channels), values);
  if (image.channels == 1)
    return all;
  cv::Mat grey;
  cv::cvtColor(all, grey, cv::COLOR_RGB2GRAY);
  return grey;
}

void
blur(const cv::Mat& image, cv::Mat& blurred, double sigma)
{
  cv::GaussianBlur(image, blurred, {}, sigma, sigma, cv::BORDER_REPLICATE);
}

} // namespace

SmoothImage::SmoothImage(const CameraImage& image)
: inverse_deviation_(image.height, image.width)
{
  blur(greyOf(image), grey_, patch_blur);
  constexpr int pixels = side * side;
  const cv::Size patch(side, side);
  const cv::Point middle(half, half);
  cv::Mat_<float> squares;
  cv::boxFilter(grey_, sum_, CV_32S, patch, middle, false);
  cv::sqrBoxFilter(grey_, squares, CV_32F, patch, middle, false);
  for (int y = 0; y < grey_.rows; ++y)
    for (int x = 0; x < grey_.cols; ++x) {
      const double sum = sum_(y, x);
      const double deviation = static_cast<double>(squares(y, x)) - sum * sum / pixels;
      const bool has_contrast = deviation >= min_contrast * min_contrast * pixels;
      inverse_deviation_(y, x) =
          has_contrast ? static_cast<float>(1.0 / std::sqrt(deviation)) : 0.0F;
    }
}

std::vector<cv::Point>
SmoothImage::corners() const
{
  constexpr int maximum = 200;
  constexpr double min_quality = 0.01; // relative to the strongest corner
  constexpr int max_in_a_row = 60;
  constexpr int window = 5; // px
  cv::Mat smoother;
  blur(grey_, smoother, std::sqrt(corner_blur * corner_blur - patch_blur * patch_blur));
  cv::Mat_<std::uint8_t> is_whole(grey_.size());
  for (int y = 0; y < grey_.rows; ++y)
    for (int x = 0; x < grey_.cols; ++x)
      is_whole(y, x) = hasPatch(x, y) ? 1 : 0;
  std::vector<cv::Point> corners;
  cv::goodFeaturesToTrack(smoother,
                          corners,
                          maximum,
                          min_quality,
                          std::max(1, grey_.cols / max_in_a_row),
                          is_whole,
                          window);
  const auto end =
      std::remove_if(corners.begin(), corners.end(), [&](cv::Point corner) {
        return !isDistinct(corner);
      });
  corners.erase(end, corners.end());
  return corners;
}

bool
SmoothImage::isDistinct(cv::Point corner) const
{
  constexpr int shift = 4;           // px
  constexpr float most_alike = 0.8F; // correlation
  const Patch patch = patchAt(corner);
  for (const int v : {-shift, 0, shift})
    for (const int u : {-shift, 0, shift})
      if ((u != 0 || v != 0) && hasPatch(corner.x + u, corner.y + v) &&
          correlate(patch, corner.x + u, corner.y + v) > most_alike)
        return false;
  return true;
}

SmoothImage::Patch
SmoothImage::patchAt(cv::Point pixel) const
{
  Patch patch;
  auto to = patch.values.begin();
  for (int y = pixel.y - half; y < pixel.y + half; ++y)
    to = std::copy_n(&grey_(y, pixel.x - half), side, to);
  patch.sum = sum_(pixel);
  patch.inverse_deviation = inverse_deviation_(pixel);
  return patch;
}

float
SmoothImage::correlate(const Patch& patch, int x, int y) const
{
  std::int32_t products = 0;
  const std::int16_t* a = patch.values.data();
  for (int row = y - half; row < y + half; ++row) {
    const std::uint8_t* const b = &grey_(row, x - half);
    for (int i = 0; i < side; ++i)
      products += *a++ * static_cast<std::int16_t>(b[i]);
  }
  const double expected = patch.sum * sum_(y, x) / (side * side);
  return static_cast<float>(products - expected) * patch.inverse_deviation *
         inverse_deviation_(y, x);
}

} // namespace pcl::acmap
