#include "plan_picture.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr int longest_side = 1000; // pixels
constexpr int least_side = 200;
constexpr int margin = 15;

bool
canBeShown(const Eigen::Vector3d& in_map)
{
  constexpr double farthest = 1e9; // metres
  return in_map.cwiseAbs().maxCoeff() < farthest && in_map.allFinite();
}

/** The range that holds all numbers but a few at each end. */
Eigen::Vector2d
rangeOf(std::vector<float> values)
{
  constexpr std::size_t few = 500; // one in so many
  const auto skipped = static_cast<std::ptrdiff_t>(values.size() / few);
  const auto least = values.begin() + skipped;
  std::nth_element(values.begin(), least, values.end());
  const double first = *least;
  const auto most = values.end() - 1 - skipped;
  std::nth_element(values.begin(), most, values.end());
  return {first, *most};
}

/** The number of points of a pixel that counts as black. */
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

void
drawScaleBar(RgbImage& image, double pixel)
{
  const double metres = roundLength(0.3 * image.width * pixel);
  const double left = margin;
  const double bottom = image.height - margin;
  const double right = left + metres / pixel;
  drawLine(image, {left, bottom}, {right, bottom}, 2, black);
  for (const double end : {left, right})
    drawLine(image, {end, bottom - 4}, {end, bottom + 4}, 2, black);
  std::ostringstream text;
  text << metres << " m";
  drawText(image, margin + 4, image.height - margin - 16, text.str(), black);
}

} // namespace

void
PlanContents::addPoint(const Eigen::Vector3d& in_map)
{
  if (!canBeShown(in_map))
    return;
  x_.push_back(static_cast<float>(in_map.x()));
  z_.push_back(static_cast<float>(in_map.z()));
}

void
PlanContents::addPlace(const Eigen::Vector3d& in_map)
{
  if (canBeShown(in_map))
    places_.extend(Eigen::Vector2d(in_map.x(), in_map.z()));
}

PlanExtent
PlanContents::extent() const
{
  Eigen::AlignedBox2d box = places_;
  if (!x_.empty()) {
    const Eigen::Vector2d range_x = rangeOf(x_);
    const Eigen::Vector2d range_z = rangeOf(z_);
    box.extend(Eigen::Vector2d(range_x[0], range_z[0]));
    box.extend(Eigen::Vector2d(range_x[1], range_z[1]));
  }
  if (box.isEmpty())
    box.extend(Eigen::Vector2d(0, 0));
  PlanExtent extent;
  extent.pixel = std::max(box.sizes().maxCoeff(), 1e-3) / (longest_side - 2 * margin);
  const auto pixels = [&](double metres) {
    const auto side = static_cast<int>(std::lround(metres / extent.pixel));
    return std::max(side + 2 * margin, least_side);
  };
  extent.width = pixels(box.sizes().x());
  extent.height = pixels(box.sizes().y());
  extent.least =
      box.center() - 0.5 * extent.pixel * Eigen::Vector2d(extent.width, extent.height);
  return extent;
}

PlanPicture::PlanPicture(const PlanExtent& extent)
: extent_(extent)
, counts_(static_cast<std::size_t>(extent.width) *
          static_cast<std::size_t>(extent.height))
{}

Eigen::Vector2d
PlanPicture::pixelOf(const Eigen::Vector3d& in_map) const
{
  return {(in_map.x() - extent_.least.x()) / extent_.pixel,
          extent_.height - 1 - (in_map.z() - extent_.least.y()) / extent_.pixel};
}

void
PlanPicture::add(const Eigen::Vector3d& in_map)
{
  const Eigen::Vector2d pixel = pixelOf(in_map);
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
  // dense clouds are shown in stronger contrast, so that walls stand out from floors
  const double contrast = std::clamp(0.5 + 0.5 * std::log10(black_count), 1.0, 2.0);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    const double share = std::min(1.0, scale * std::log1p(counts_[i]));
    const double light = 1 - std::pow(share, contrast);
    const auto level = static_cast<std::uint8_t>(std::lround(255 * light));
    std::fill_n(&image.values[3 * i], 3, level);
  }
  for (std::size_t i = 1; i < poses.size(); ++i)
    drawLine(image,
             pixelOf(poses[i - 1].translation()),
             pixelOf(poses[i].translation()),
             2,
             color);
  if (!poses.empty()) {
    const Eigen::Vector2d begin = pixelOf(poses.front().translation());
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
