#include "egomotion_pictures.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl::acmap {

namespace {

using Poses = std::vector<std::optional<Eigen::Isometry3d>>;

constexpr Color pale = {225, 225, 225};
constexpr int legend_height = 56; // pixels, below the plan
constexpr int legend_width = 80;  // pixels, to the right of the plan

PlanExtent
extentOf(const Poses& poses, const std::vector<Eigen::Isometry3d>& truth)
{
  PlanContents contents;
  for (const auto& pose : poses)
    if (pose)
      contents.addPlace(pose->translation());
  for (const Eigen::Isometry3d& pose : truth)
    contents.addPlace(pose.translation());
  return contents.extent();
}

std::string
metresText(const char* axis, double metres, double step)
{
  std::ostringstream text;
  text.precision(6);
  text << axis << " " << (std::abs(metres) < 1e-6 * step ? 0.0 : metres) << " m";
  return text.str();
}

/** Grid lines at round x and z, with labels below and on the right. */
void
drawGrid(RgbImage& image, const PlanExtent& extent)
{
  const double step =
      roundLength(0.2 * extent.pixel * std::max(extent.width, extent.height));
  const Eigen::Vector2d most =
      extent.least + extent.pixel * Eigen::Vector2d(extent.width, extent.height);
  for (double x = std::ceil(extent.least.x() / step) * step; x < most.x(); x += step) {
    const double column = extent.pixelOf({x, 0, 0}).x();
    drawLine(image, {column, 0}, {column, extent.height - 1.0}, 1, pale);
    drawText(image,
             static_cast<int>(column),
             extent.height + 4,
             metresText("x", x, step),
             gray);
  }
  for (double z = std::ceil(extent.least.y() / step) * step; z < most.y(); z += step) {
    const double row = extent.pixelOf({0, 0, z}).y();
    drawLine(image, {0, row}, {extent.width - 1.0, row}, 1, pale);
    drawText(image,
             extent.width + 4,
             static_cast<int>(row) - text_height / 2,
             metresText("z", z, step),
             gray);
  }
}

void
drawDashes(RgbImage& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  constexpr double dash = 6; // pixels
  const int dashes = 1 + 2 * static_cast<int>((to - from).norm() / (2 * dash));
  for (int i = 0; i < dashes; i += 2)
    drawLine(image,
             from + (to - from) * i / dashes,
             from + (to - from) * (i + 1) / dashes,
             2,
             red);
}

void
drawCross(RgbImage& image, const Eigen::Vector2d& at)
{
  constexpr double arm = 4; // pixels
  drawLine(
      image, at - Eigen::Vector2d(arm, arm), at + Eigen::Vector2d(arm, arm), 2, red);
  drawLine(
      image, at - Eigen::Vector2d(arm, -arm), at + Eigen::Vector2d(arm, -arm), 2, red);
}

/** Draws lost observations equally spaced between the posed ones before and after
 * them. */
void
drawGap(RgbImage& image,
        const Eigen::Vector2d& from,
        const Eigen::Vector2d& to,
        std::size_t lost)
{
  drawDashes(image, from, to);
  for (std::size_t i = 1; i <= lost; ++i)
    drawCross(image,
              from +
                  (to - from) * static_cast<double>(i) / static_cast<double>(lost + 1));
}

void
drawWay(RgbImage& image, const PlanExtent& extent, const Poses& poses)
{
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i])
      continue;
    const Eigen::Vector2d at = extent.pixelOf(poses[i]->translation());
    if (!last) {
      drawLine(image, at, at, 9, blue);
    }
    else {
      const Eigen::Vector2d before = extent.pixelOf(poses[*last]->translation());
      const std::size_t lost = i - *last - 1;
      if (lost > 0)
        drawGap(image, before, at, lost);
      else
        drawLine(image, before, at, 2, blue);
    }
    last = i;
  }
}

void
drawTruth(RgbImage& image,
          const PlanExtent& extent,
          const std::vector<Eigen::Isometry3d>& truth)
{
  for (std::size_t i = 1; i < truth.size(); ++i)
    drawLine(image,
             extent.pixelOf(truth[i - 1].translation()),
             extent.pixelOf(truth[i].translation()),
             2,
             gray);
}

/** Observations lost at the end have no position in the picture. */
void
drawCount(RgbImage& image, const Poses& poses)
{
  const auto posed = std::count_if(
      poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); });
  const std::string text =
      std::to_string(posed) + " of " + std::to_string(poses.size()) + " posed";
  drawText(image,
           image.width - 8 - static_cast<int>(text.size()) * text_advance,
           image.height - 15 - text_height,
           text,
           black);
}

/** Number of strokes that can be distinguished. */
void
drawDirections(RgbImage& image, const PlanExtent& extent, const Poses& poses)
{
  constexpr std::size_t most = 80;
  constexpr double stroke = 16; // pixels
  const std::size_t every = 1 + poses.size() / most;
  for (std::size_t i = 0; i < poses.size(); i += every) {
    if (!poses[i])
      continue;
    const Eigen::Vector3d ahead = poses[i]->linear().col(2);
    const Eigen::Vector2d at = extent.pixelOf(poses[i]->translation());
    drawLine(image, at, at + stroke * Eigen::Vector2d(ahead.x(), -ahead.z()), 1, black);
  }
}

} // namespace

RgbImage
wayPicture(const Poses& poses, const std::vector<Eigen::Isometry3d>& truth)
{
  const PlanExtent extent = extentOf(poses, truth);
  RgbImage image =
      whiteImage(extent.width + legend_width, extent.height + legend_height);
  drawGrid(image, extent);
  drawTruth(image, extent, truth);
  drawDirections(image, extent, poses);
  drawWay(image, extent, poses);
  drawScaleBar(image, extent.pixel);
  drawCount(image, poses);
  return image;
}

} // namespace pcl::acmap
