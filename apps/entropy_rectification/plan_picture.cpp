#include "plan_picture.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** The number of points per pixel that is shown as black. */
double
blackCount(std::vector<std::uint32_t> counts)
{
  counts.erase(std::remove(counts.begin(), counts.end(), 0U), counts.end());
  if (counts.empty())
    return 1;
  const auto high =
      counts.begin() + static_cast<std::ptrdiff_t>(counts.size() * 98 / 100);
  std::nth_element(counts.begin(), high, counts.end());
  return std::max(1.0, static_cast<double>(*high));
}

} // namespace

PlanPicture::PlanPicture(const PlanExtent& extent)
: extent_(extent)
, counts_(static_cast<std::size_t>(extent.width) *
          static_cast<std::size_t>(extent.height))
{}

void
PlanPicture::add(const Eigen::Vector3d& in_map)
{
  const Eigen::Vector2d pixel = extent_.pixelOf(in_map);
  if (!(pixel.x() >= 0 && pixel.x() < extent_.width && pixel.y() >= 0 &&
        pixel.y() < extent_.height))
    return;
  const auto row = static_cast<std::size_t>(pixel.y());
  const auto column = static_cast<std::size_t>(pixel.x());
  std::uint32_t& count =
      counts_[row * static_cast<std::size_t>(extent_.width) + column];
  count += count < 0xffffffffU ? 1 : 0;
}

RgbImage
PlanPicture::draw(const std::vector<Eigen::Isometry3d>& poses, const Color& color) const
{
  RgbImage image = whiteImage(extent_.width, extent_.height);
  const double black_count = blackCount(counts_);
  const double scale = 1 / std::log1p(black_count);
  // dense clouds are shown with more contrast, so that walls stand out from floors
  const double contrast = std::clamp(0.5 + 0.5 * std::log10(black_count), 1.0, 2.0);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const double share = std::min(1.0, scale * std::log1p(counts_[i]));
    const double light = 1 - std::pow(share, contrast);
    const auto level = static_cast<std::uint8_t>(std::lround(255 * light));
    std::fill_n(&image.values[3 * i], 3, level);
  }
  for (std::size_t i = 1; i < poses.size(); ++i)
    drawLine(image,
             extent_.pixelOf(poses[i - 1].translation()),
             extent_.pixelOf(poses[i].translation()),
             2,
             color);
  if (!poses.empty()) {
    const Eigen::Vector2d begin = extent_.pixelOf(poses.front().translation());
    drawLine(image, begin, begin, 9, color);
  }
  drawScaleBar(image, extent_.pixel);
  return image;
}

RgbImage
beside(const RgbImage& left, const RgbImage& right)
{
  constexpr int gap = 6;
  RgbImage image = whiteImage(left.width + gap + right.width, left.height);
  paste(left, 0, 0, image);
  const double middle = left.width + 0.5 * (gap - 1);
  drawLine(image, {middle, 0}, {middle, left.height - 1.0}, 1, gray);
  paste(right, left.width + gap, 0, image);
  return image;
}

} // namespace pcl::acmap
