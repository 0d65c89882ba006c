#include "naive_egomotion.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

namespace {

using Cloud = PointCloud<PointXYZRGBSigma>;

constexpr int rings = 12, sectors = 24;
constexpr int reach = 20; // pixels

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
                  height - 1 - pixel / width}) > reach)
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
