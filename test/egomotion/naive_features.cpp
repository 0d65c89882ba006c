#include "naive_egomotion.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

NaiveImage
blurred(const NaiveImage& image, double sigma)
{
  const int reach = static_cast<int>(std::ceil(3 * sigma));
  NaiveImage result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      double sum = 0, weights = 0;
      for (int v = -reach; v <= reach; ++v)
        for (int u = -reach; u <= reach; ++u) {
          const double weight = std::exp(-(u * u + v * v) / (2 * sigma * sigma));
          sum += weight * image.at(x + u, y + v);
          weights += weight;
        }
      result.values[static_cast<std::size_t>(y * image.width + x)] = sum / weights;
    }
  return result;
}

NaiveImage::NaiveImage(const PointCloud<PointXYZRGBSigma>& cloud)
: width(static_cast<int>(cloud.width))
, height(static_cast<int>(cloud.height))
{
  for (const PointXYZRGBSigma& point : cloud)
    values.push_back(0.299 * point.r + 0.587 * point.g + 0.114 * point.b);
}

double
NaiveImage::at(int x, int y) const
{
  x = std::clamp(x, 0, width - 1);
  return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width + x)];
}

std::vector<int>
naiveKeypoints(const PointCloud<PointXYZRGBSigma>& cloud)
{
  const NaiveImage image = blurred(NaiveImage(cloud), 1);
  const auto gradient = [&](int x, int y) {
    return std::hypot(image.at(x + 1, y) - image.at(x - 1, y),
                      image.at(x, y + 1) - image.at(x, y - 1));
  };
  std::vector<int> pixels;
  for (int y = 2; y + 2 < image.height; ++y)
    for (int x = 2; x + 2 < image.width; ++x) {
      int smaller = 0;
      for (int v = -1; v <= 1; ++v)
        for (int u = -1; u <= 1; ++u)
          smaller += gradient(x + u, y + v) < gradient(x, y);
      const int pixel = y * image.width + x;
      if (smaller == 8 && std::isfinite(cloud[pixel].z))
        pixels.push_back(pixel);
    }
  return pixels;
}

std::vector<double>
patchAt(const NaiveImage& image, int pixel)
{
  constexpr int rings = 12, sectors = 24;
  constexpr double outer = 20, full_turn = 6.283185307179586;
  std::vector<double> samples;
  for (int k = 0; k < rings; ++k)
    for (int m = 0; m < sectors; ++m) {
      const double radius = std::pow(outer, k / (rings - 1.0));
      const double x = pixel % image.width + radius * std::cos(full_turn * m / sectors);
      const double y = pixel / image.width + radius * std::sin(full_turn * m / sectors);
      const int left = static_cast<int>(std::floor(x)),
                up = static_cast<int>(std::floor(y));
      const double a = x - left, b = y - up;
      samples.push_back((1 - a) * (1 - b) * image.at(left, up) +
                        a * (1 - b) * image.at(left + 1, up) +
                        (1 - a) * b * image.at(left, up + 1) +
                        a * b * image.at(left + 1, up + 1));
    }
  return samples;
}

} // namespace pcl::acmap::test
