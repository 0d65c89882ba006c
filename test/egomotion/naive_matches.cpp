#include "naive_egomotion.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

namespace {

using Cloud = PointCloud<PointXYZRGBSigma>;

constexpr int rings = 12, sectors = 24;
constexpr double outer = 20, full_turn = 6.283185307179586;

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

/** Samples between four pixels, ring by ring. */
std::vector<double>
patchAt(const NaiveImage& image, int pixel)
{
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

double
pearson(const std::vector<double>& a, const std::vector<double>& b, int ring, int turn)
{
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (int k = std::max(0, -ring); k < std::min(rings, rings - ring); ++k)
    for (int m = 0; m < sectors; ++m) {
      const double p = a[static_cast<std::size_t>((k + ring) * sectors +
                                                  (m + turn + sectors) % sectors)];
      const double q = b[static_cast<std::size_t>(k * sectors + m)];
      n += 1, sa += p, sb += q, saa += p * p, sbb += q * q, sab += p * q;
    }
  return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

/** Keypoints far enough from the border for a patch. */
std::vector<int>
placesOf(const Cloud& cloud)
{
  std::vector<int> pixels;
  const int width = static_cast<int>(cloud.width),
            height = static_cast<int>(cloud.height);
  for (const int pixel : naiveKeypoints(cloud))
    if (std::min({pixel % width,
                  pixel / width,
                  width - 1 - pixel % width,
                  height - 1 - pixel / width}) > outer)
      pixels.push_back(pixel);
  return pixels;
}

/** Is entry `which` the best of a row of scores, strong and distinct? */
bool
isChosen(const std::vector<double>& scores,
         std::size_t which,
         const std::vector<int>& pixels,
         int width)
{
  double second = -1;
  for (std::size_t j = 0; j < scores.size(); ++j) {
    if (scores[j] > scores[which])
      return false;
    if (std::hypot(pixels[j] % width - pixels[which] % width,
                   pixels[j] / width - pixels[which] / width) > 3)
      second = std::max(second, scores[j]);
  }
  return scores[which] >= 0.8 && 1.003 - scores[which] < 0.7 * (1.003 - second);
}

} // namespace

NaiveImage::NaiveImage(const Cloud& cloud)
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
naiveKeypoints(const Cloud& cloud)
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

NaiveMatches
naiveMatches(const Cloud& source,
             const Cloud& target,
             int ring_shifts,
             int sector_shifts)
{
  const std::vector<int> from = placesOf(source), to = placesOf(target);
  const NaiveImage now = blurred(NaiveImage(source), 1.4);
  const NaiveImage before = blurred(NaiveImage(target), 1.4);
  std::vector<std::vector<double>> rows(from.size(), std::vector<double>(to.size()));
  std::vector<std::vector<double>> columns(to.size(), std::vector<double>(from.size()));
  std::vector<std::vector<double>> patches;
  for (const int pixel : to)
    patches.push_back(patchAt(before, pixel));
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::vector<double> patch = patchAt(now, from[i]);
    for (std::size_t j = 0; j < to.size(); ++j) {
      double best = -1;
      for (int ring = -ring_shifts; ring <= ring_shifts; ++ring)
        for (int turn = -sector_shifts; turn <= sector_shifts; ++turn)
          best = std::max(best, pearson(patch, patches[j], ring, turn));
      rows[i][j] = columns[j][i] = best;
    }
  }
  NaiveMatches matches;
  for (std::size_t i = 0; i < from.size(); ++i)
    for (std::size_t j = 0; j < to.size(); ++j)
      if (isChosen(rows[i], j, to, before.width) &&
          isChosen(columns[j], i, from, now.width))
        matches.emplace_back(from[i], to[j]);
  return matches;
}

} // namespace pcl::acmap::test
