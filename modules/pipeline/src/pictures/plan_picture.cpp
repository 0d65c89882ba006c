#include "pictures/drawing.h"

#include <pcl/pipeline/plan_picture.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl {

namespace {

using acmap::Color;

constexpr int longest_side_of_plan = 1000; // pixels
constexpr int min_side_of_plan = 200;
constexpr int plan_margin = 15;

bool
isInPlan(const Eigen::Vector3d& in_map)
{
  constexpr double farthest = 1e9; // metres
  return in_map.cwiseAbs().maxCoeff() < farthest && in_map.allFinite();
}

/** The range of the numbers without the outermost ones at each end. */
Eigen::Vector2d
rangeInPlan(std::vector<float> values)
{
  constexpr std::size_t few = 500; // fraction 1 / 500 at each end
  const auto skipped = static_cast<std::ptrdiff_t>(values.size() / few);
  const auto minimum = values.begin() + skipped;
  std::nth_element(values.begin(), minimum, values.end());
  const double first = *minimum;
  const auto maximum = values.end() - 1 - skipped;
  std::nth_element(values.begin(), maximum, values.end());
  return {first, *maximum};
}

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

/** Draws a bar of a round length into the lower left corner, labelled in metres. */
void
drawPlanScale(cv::Mat3b& image, double metres_per_pixel)
{
  const double metres = acmap::roundLength(0.3 * image.cols * metres_per_pixel);
  const Eigen::Vector2d left(plan_margin, image.rows - plan_margin);
  const Eigen::Vector2d right = left + Eigen::Vector2d(metres / metres_per_pixel, 0);
  const Eigen::Vector2d up(0, 4);
  acmap::drawLine(image, left, right, 1, acmap::black);
  for (const Eigen::Vector2d& end : {left, right})
    acmap::drawLine(image, end - up, end + up, 1, acmap::black);
  std::ostringstream text;
  text << metres << " m";
  acmap::drawText(image, 0.5 * (left + right) - 3 * up, text.str(), acmap::black, 0.5);
}

} // namespace

void
PlanContents::addPoint(const Eigen::Vector3d& in_map)
{
  if (!isInPlan(in_map))
    return;
  x_.push_back(static_cast<float>(in_map.x()));
  z_.push_back(static_cast<float>(in_map.z()));
}

void
PlanContents::addPlace(const Eigen::Vector3d& in_map)
{
  if (isInPlan(in_map))
    places_.extend(Eigen::Vector2d(in_map.x(), in_map.z()));
}

PlanExtent
PlanContents::extent() const
{
  Eigen::AlignedBox2d box = places_;
  if (!x_.empty()) {
    const Eigen::Vector2d range_x = rangeInPlan(x_);
    const Eigen::Vector2d range_z = rangeInPlan(z_);
    box.extend(Eigen::Vector2d(range_x[0], range_z[0]));
    box.extend(Eigen::Vector2d(range_x[1], range_z[1]));
  }
  if (box.isEmpty())
    box.extend(Eigen::Vector2d(0, 0));
  PlanExtent extent;
  extent.pixel =
      std::max(box.sizes().maxCoeff(), 1e-3) / (longest_side_of_plan - 2 * plan_margin);
  const auto pixels = [&](double metres) {
    const auto side = static_cast<int>(std::lround(metres / extent.pixel));
    return std::max(side + 2 * plan_margin, min_side_of_plan);
  };
  extent.width = pixels(box.sizes().x());
  extent.height = pixels(box.sizes().y());
  extent.minimum =
      box.center() - 0.5 * extent.pixel * Eigen::Vector2d(extent.width, extent.height);
  return extent;
}

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
PlanPicture::draw(const std::vector<Eigen::Isometry3d>& poses,
                  const std::array<std::uint8_t, 3>& color) const
{
  const Color line_color(color[0], color[1], color[2]);
  cv::Mat3b image(extent_.height, extent_.width);
  const double black_count = blackCount(counts_);
  const double scale = 1 / std::log1p(black_count);
  // dense clouds are shown with more contrast, so that walls stand out from floors
  const double contrast = std::clamp(0.5 + 0.5 * std::log10(black_count), 1.0, 2.0);
  std::transform(
      counts_.begin(), counts_.end(), image.begin(), [&](std::uint32_t count) {
        const double share = std::min(1.0, scale * std::log1p(count));
        return Color::all(cv::saturate_cast<std::uint8_t>(
            std::lround(255 * (1 - std::pow(share, contrast)))));
      });
  for (std::size_t i = 1; i < poses.size(); ++i)
    acmap::drawLine(image,
                    extent_.pixelOf(poses[i - 1].translation()),
                    extent_.pixelOf(poses[i].translation()),
                    2,
                    line_color);
  if (!poses.empty())
    acmap::drawDot(image, extent_.pixelOf(poses.front().translation()), 5, line_color);
  drawPlanScale(image, extent_.pixel);
  return acmap::rgbImageOf(image);
}

} // namespace pcl
