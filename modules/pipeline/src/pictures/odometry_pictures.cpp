#include "pictures/drawing.h"

#include <pcl/pipeline/odometry_pictures.h>
#include <pcl/pipeline/plan_picture.h>

#include <algorithm>
#include <array>

namespace pcl {

namespace {

using acmap::Color;
using acmap::drawDot;
using acmap::drawLine;
using View = PointCloud<PointXYZRGBSigma>;
using MaybePoses = std::vector<std::optional<Eigen::Isometry3d>>;

const Color green(40, 200, 60);
const Color light_red(255, 70, 60);

/** A grey image, stretched from black to below white for any lighting, so that lines
 * stand out. It has few grey levels, since noise would make large files. */
cv::Mat3b
greyImageOf(const View& cloud)
{
  std::vector<int> greys;
  for (const PointXYZRGBSigma& point : cloud)
    greys.push_back(2 * point.r + 5 * point.g + point.b);
  std::vector<int> sorted = greys;
  const auto few = static_cast<std::ptrdiff_t>(sorted.size() / 50);
  std::nth_element(sorted.begin(), sorted.begin() + few, sorted.end());
  const int dark = sorted[static_cast<std::size_t>(few)];
  std::nth_element(sorted.begin(), sorted.end() - 1 - few, sorted.end());
  const int range = std::max(*(sorted.end() - 1 - few) - dark, 1);
  cv::Mat3b image(static_cast<int>(cloud.height), static_cast<int>(cloud.width));
  std::transform(greys.begin(), greys.end(), image.begin(), [&](int grey) {
    constexpr int step = 16, steps = 12;
    const int level = std::clamp((grey - dark) * steps / range, 0, steps);
    return Color::all(static_cast<std::uint8_t>(step * level));
  });
  return image;
}

Eigen::Vector2d
pixelOfPoint(const View& cloud, index_t index)
{
  const auto width = static_cast<index_t>(cloud.width);
  return {index % width, index / width};
}

PlanExtent
extentOfPath(const MaybePoses& poses, const std::vector<Eigen::Isometry3d>& truth)
{
  PlanContents contents;
  for (const auto& pose : poses)
    if (pose)
      contents.addPlace(pose->translation());
  for (const Eigen::Isometry3d& pose : truth)
    contents.addPlace(pose.translation());
  return contents.extent();
}

/** Draws a dashed line, with lost observations equally spaced between the posed ones
 * before and after them. */
void
drawGap(cv::Mat3b& image,
        const Eigen::Vector2d& from,
        const Eigen::Vector2d& to,
        std::size_t lost)
{
  constexpr double dash = 6, arm = 4; // pixels
  const Eigen::Vector2d along = to - from;
  const int dashes = 1 + 2 * static_cast<int>(along.norm() / (2 * dash));
  for (int i = 0; i < dashes; i += 2)
    drawLine(image,
             from + along * i / dashes,
             from + along * (i + 1) / dashes,
             2,
             acmap::red);
  for (std::size_t i = 1; i <= lost; ++i) {
    const Eigen::Vector2d at =
        from + along * static_cast<double>(i) / static_cast<double>(lost + 1);
    for (const Eigen::Vector2d& half : {Eigen::Vector2d(arm, arm), {arm, -arm}})
      drawLine(image, at - half, at + half, 2, acmap::red);
  }
}

void
drawTrajectory(cv::Mat3b& image, const PlanExtent& extent, const MaybePoses& poses)
{
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i])
      continue;
    const Eigen::Vector2d at = extent.pixelOf(poses[i]->translation());
    if (!last)
      drawDot(image, at, 5, acmap::blue);
    else {
      const Eigen::Vector2d before = extent.pixelOf(poses[*last]->translation());
      if (const std::size_t lost = i - *last - 1)
        drawGap(image, before, at, lost);
      else
        drawLine(image, before, at, 2, acmap::blue);
    }
    last = i;
  }
}

void
drawDirections(cv::Mat3b& image, const PlanExtent& extent, const MaybePoses& poses)
{
  constexpr std::size_t maximum = 80; // number of strokes that can be distinguished
  constexpr double stroke = 16;       // pixels
  for (std::size_t i = 0; i < poses.size(); i += 1 + poses.size() / maximum) {
    if (!poses[i])
      continue;
    const Eigen::Vector3d ahead = poses[i]->linear().col(2);
    const Eigen::Vector2d at = extent.pixelOf(poses[i]->translation());
    drawLine(image,
             at,
             at + stroke * Eigen::Vector2d(ahead.x(), -ahead.z()),
             1,
             acmap::black);
  }
}

} // namespace

RgbImage
matchPicture(const View& now,
             const View& before,
             const Correspondences& matches,
             const Correspondences& kept)
{
  constexpr int gap = 6, caption_height = 22; // pixels
  const cv::Mat3b left = greyImageOf(before), right = greyImageOf(now);
  const int shift = left.cols + gap;
  const int row_height = left.rows + caption_height;
  cv::Mat3b image(2 * row_height, shift + right.cols, acmap::white);
  const auto drawRow =
      [&](int top, const Correspondences& pairs, const char* what, const Color& color) {
        acmap::drawText(image,
                        {4, top + 0.5 * caption_height},
                        std::to_string(pairs.size()) + what,
                        acmap::black);
        cv::Mat3b views = image.rowRange(top + caption_height, top + row_height);
        left.copyTo(views.colRange(0, left.cols));
        right.copyTo(views.colRange(shift, views.cols));
        const auto ends = [&](const Correspondence& pair) {
          return std::array{pixelOfPoint(before, pair.index_match),
                            Eigen::Vector2d(pixelOfPoint(now, pair.index_query) +
                                            Eigen::Vector2d(shift, 0))};
        };
        // the views stay visible under many lines; halves are exact
        cv::Mat3b lines = views.clone();
        for (const Correspondence& pair : pairs)
          drawLine(lines, ends(pair)[0], ends(pair)[1], 1, color);
        cv::addWeighted(lines, 0.5, views, 0.5, 0, views);
        for (const Correspondence& pair : pairs)
          for (const Eigen::Vector2d& end : ends(pair))
            drawDot(views, end, 2, color);
      };
  drawRow(0, matches, " matches look alike", light_red);
  drawRow(row_height, kept, " matches agree on the motion", green);
  return acmap::rgbImageOf(image);
}

RgbImage
trajectoryPicture(const MaybePoses& poses, const std::vector<Eigen::Isometry3d>& truth)
{
  const PlanExtent extent = extentOfPath(poses, truth);
  const cv::Size size(extent.width, extent.height);
  const Eigen::Vector2d maximum =
      extent.minimum + extent.pixel * Eigen::Vector2d(size.width - 1, size.height - 1);
  acmap::Plot plot(size, {extent.minimum, maximum}, "x [m]", "z [m]");
  for (std::size_t i = 1; i < truth.size(); ++i)
    drawLine(plot.inside(),
             extent.pixelOf(truth[i - 1].translation()),
             extent.pixelOf(truth[i].translation()),
             2,
             acmap::gray);
  drawDirections(plot.inside(), extent, poses);
  drawTrajectory(plot.inside(), extent, poses);
  // observations lost at the end have no position in the picture
  const auto posed = static_cast<std::size_t>(std::count_if(
      poses.begin(), poses.end(), [](const auto& pose) { return pose.has_value(); }));
  plot.addToLegend(std::to_string(posed) + " of " + std::to_string(poses.size()) +
                       " posed",
                   acmap::blue);
  if (posed < poses.size())
    plot.addToLegend(std::to_string(poses.size() - posed) + " lost", acmap::red);
  if (!truth.empty())
    plot.addToLegend("truth", acmap::gray);
  return plot.picture();
}

} // namespace pcl
