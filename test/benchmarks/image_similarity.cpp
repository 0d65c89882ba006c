#include "image_similarity.h"

namespace pcl::acmap::bench {
namespace {

constexpr std::size_t side = 8, stride = 4;

double
brightness(const std::vector<std::uint8_t>& image, std::size_t pixel)
{
  return 0.299 * image[3 * pixel] + 0.587 * image[3 * pixel + 1] +
         0.114 * image[3 * pixel + 2];
}

struct ImageSums {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

double
ssim(const ImageSums& sums)
{
  constexpr double count = side * side;
  constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
  const double mean_a = sums.a / count, mean_b = sums.b / count;
  const double var_a = sums.aa / count - mean_a * mean_a;
  const double var_b = sums.bb / count - mean_b * mean_b;
  const double covariance = sums.ab / count - mean_a * mean_b;
  return (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
         ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
}

} // namespace

Similarity
structuralSimilarity(const std::vector<std::uint8_t>& a,
                     const std::vector<std::uint8_t>& b,
                     const std::vector<std::uint8_t>& is_known,
                     std::size_t width)
{
  const std::size_t height = is_known.size() / width;
  Similarity similarity;
  for (std::size_t top = 0; top + side <= height; top += stride)
    for (std::size_t left = 0; left + side <= width; left += stride) {
      ImageSums sums;
      bool is_whole = true;
      for (std::size_t row = top; row < top + side && is_whole; ++row)
        for (std::size_t column = left; column < left + side; ++column) {
          const std::size_t pixel = row * width + column;
          is_whole = is_whole && is_known[pixel];
          const double x = brightness(a, pixel), y = brightness(b, pixel);
          sums.a += x;
          sums.b += y;
          sums.aa += x * x;
          sums.bb += y * y;
          sums.ab += x * y;
        }
      if (!is_whole)
        continue;
      similarity.mean += ssim(sums);
      ++similarity.windows;
    }
  if (similarity.windows > 0)
    similarity.mean /= static_cast<double>(similarity.windows);
  return similarity;
}

} // namespace pcl::acmap::bench
