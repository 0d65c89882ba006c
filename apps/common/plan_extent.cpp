#include "plan_extent.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

namespace {

constexpr int longest_side = 1000; // pixels
constexpr int min_side = 200;
constexpr int margin = 15;

bool
canBeShown(const Eigen::Vector3d& in_map)
{
  constexpr double farthest = 1e9; // metres
  return in_map.cwiseAbs().maxCoeff() < farthest && in_map.allFinite();
}

/** The range of the numbers without the outermost ones at each end. */
Eigen::Vector2d
rangeOf(std::vector<float> values)
{
  constexpr std::size_t few = 500; // fraction 1 / 500 at each end
  const auto skipped = static_cast<std::ptrdiff_t>(values.size() / few);
  const auto least = values.begin() + skipped;
  std::nth_element(values.begin(), least, values.end());
  const double first = *least;
  const auto most = values.end() - 1 - skipped;
  std::nth_element(values.begin(), most, values.end());
  return {first, *most};
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
    return std::max(side + 2 * margin, min_side);
  };
  extent.width = pixels(box.sizes().x());
  extent.height = pixels(box.sizes().y());
  extent.least =
      box.center() - 0.5 * extent.pixel * Eigen::Vector2d(extent.width, extent.height);
  return extent;
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

} // namespace pcl::acmap
