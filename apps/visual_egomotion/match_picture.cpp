#include "egomotion_pictures.h"

#include <algorithm>
#include <vector>

namespace pcl::acmap {

namespace {

using Cloud = PointCloud<PointXYZRGBSigma>;

constexpr int gap = 6; // pixels, between the views
constexpr int caption_height = text_height + 8;
constexpr Color green = {40, 200, 60};
constexpr Color light_red = {255, 70, 60};

/** A grey image, stretched from black to below white for any lighting, so that lines
 * stand out. It has few grey levels, since noise would make large files. */
RgbImage
imageOf(const Cloud& cloud)
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
  constexpr int step = 16, steps = 12;
  RgbImage image =
      whiteImage(static_cast<int>(cloud.width), static_cast<int>(cloud.height));
  for (std::size_t i = 0; i < greys.size(); ++i) {
    const int grey = step * std::clamp((greys[i] - dark) * steps / range, 0, steps);
    std::fill_n(&image.values[3 * i], 3, static_cast<std::uint8_t>(grey));
  }
  return image;
}

Eigen::Vector2d
pixelOf(const Cloud& cloud, index_t index)
{
  const auto width = static_cast<index_t>(cloud.width);
  return {index % width, index / width};
}

} // namespace

RgbImage
matchPicture(const Cloud& now,
             const Cloud& before,
             const Correspondences& matches,
             const Correspondences& kept)
{
  const RgbImage left = imageOf(before), right = imageOf(now);
  const int row_height = left.height + caption_height;
  RgbImage image = whiteImage(left.width + gap + right.width, 2 * row_height);
  const auto drawRow =
      [&](int top, const Correspondences& pairs, const char* what, const Color& color) {
        const int first_row = top + caption_height;
        drawText(image, 4, top + 4, std::to_string(pairs.size()) + what, black);
        paste(left, 0, first_row, image);
        paste(right, left.width + gap, first_row, image);
        for (const Correspondence& pair : pairs) {
          const Eigen::Vector2d from =
              pixelOf(before, pair.index_match) + Eigen::Vector2d(0, first_row);
          const Eigen::Vector2d to = pixelOf(now, pair.index_query) +
                                     Eigen::Vector2d(left.width + gap, first_row);
          drawLine(image, from, to, 0.2, color);
          for (const Eigen::Vector2d& end : {from, to})
            drawLine(image, end, end, 3, color);
        }
      };
  drawRow(0, matches, " matches look alike", light_red);
  drawRow(row_height, kept, " matches agree on the motion", green);
  return image;
}

} // namespace pcl::acmap
