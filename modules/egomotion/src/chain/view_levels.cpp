#include "chain/view_levels.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::acmap {

namespace {

/** \brief The image at half its size; each value is the mean of 4 x 4 with the weights
 * 1 3 3 1. */
GreyImage
halved(const GreyImage& image)
{
  GreyImage half;
  half.width = image.width / 2;
  half.height = image.height / 2;
  half.values.resize(pixelAt(half.width, 0, half.height));
  oneapi::tbb::parallel_for(0, half.height, [&](int row) {
    std::vector<float> sums(static_cast<std::size_t>(image.width));
    const auto line = [&](int y) {
      return &image.values[pixelAt(image.width, 0, std::clamp(y, 0, image.height - 1))];
    };
    const float* a = line(2 * row - 1);
    const float* b = line(2 * row);
    const float* c = line(2 * row + 1);
    const float* d = line(2 * row + 2);
    for (std::size_t x = 0; x < sums.size(); ++x)
      sums[x] = a[x] + d[x] + 3 * (b[x] + c[x]);
    for (int column = 0; column < half.width; ++column) {
      const auto sum = [&](int x) {
        return sums[static_cast<std::size_t>(std::clamp(x, 0, image.width - 1))];
      };
      half.values[pixelAt(half.width, column, row)] =
          (sum(2 * column - 1) + sum(2 * column + 2) +
           3 * (sum(2 * column) + sum(2 * column + 1))) /
          64;
    }
  });
  return half;
}

/** \brief Mean of four points on one surface; NaN if there are fewer, or across an edge
 * in depth. */
Eigen::Vector3f
pointOf(const std::vector<Eigen::Vector3f>& points, int width, int column, int row)
{
  constexpr float max_spread = 0.05F; // relative to the depth
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float nearest = std::numeric_limits<float>::infinity(), farthest = 0;
  for (const int y : {2 * row, 2 * row + 1})
    for (const int x : {2 * column, 2 * column + 1}) {
      const Eigen::Vector3f& point = points[pixelAt(width, x, y)];
      sum += point;
      nearest = std::min(nearest, point.z());
      farthest = std::max(farthest, point.z());
    }
  if (!sum.allFinite() || !(farthest - nearest <= max_spread * nearest))
    return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  return sum / 4;
}

std::vector<Eigen::Vector3f>
halvedPoints(const std::vector<Eigen::Vector3f>& points,
             int width,
             const GreyImage& half)
{
  std::vector<Eigen::Vector3f> halves(half.values.size());
  oneapi::tbb::parallel_for(0, half.height, [&](int row) {
    for (int column = 0; column < half.width; ++column)
      halves[pixelAt(half.width, column, row)] = pointOf(points, width, column, row);
  });
  return halves;
}

} // namespace

float
imageNoise(const GreyImage& image)
{
  constexpr float minimum = 0.3F; // grey levels, noise of rounding to integers
  constexpr int step = 3;
  std::vector<float> curvatures;
  for (int y = 1; y + 1 < image.height; y += step)
    for (int x = 1; x + 1 < image.width; x += step) {
      const float* value = &image.values[pixelAt(image.width, x, y)];
      const float* above = value - image.width;
      const float* below = value + image.width;
      curvatures.push_back(std::abs(4 * value[0] -
                                    2 * (value[-1] + value[1] + *above + *below) +
                                    above[-1] + above[1] + below[-1] + below[1]));
    }
  if (curvatures.empty())
    return minimum;
  return std::max(medianOf(curvatures) / 6 / 0.6745F,
                  minimum); // 6: length of the filter
}

std::vector<ViewLevel>
viewLevels(const CameraView& view)
{
  constexpr int max_levels = 4;
  constexpr int min_side = 40;
  // The weights 1 3 3 1 leave 20 / 64 of white noise, and more of halved images.
  constexpr float white_left = 20.0F / 64.0F, halved_left = 0.47F;
  std::vector<ViewLevel> levels{{view.image, view.points, imageNoise(view.image), 1}};
  while (levels.size() < max_levels) {
    const ViewLevel& last = levels.back();
    if (std::min(last.image.width, last.image.height) < 2 * min_side)
      break;
    ViewLevel level;
    level.image = halved(last.image);
    level.points = halvedPoints(last.points, last.image.width, level.image);
    level.noise =
        std::max(last.noise * (last.scale == 1 ? white_left : halved_left), 0.1F);
    level.scale = 2 * last.scale;
    levels.push_back(std::move(level));
  }
  return levels;
}

} // namespace pcl::acmap
