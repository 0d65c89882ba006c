#include "painted_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap::test {
namespace {

/** The norm of the gradient in double precision, as documented in the header. */
class NaiveGradient {
public:
  explicit NaiveGradient(const GreyImage& image)
  : image_(image)
  {}

  double
  at(int x, int y) const
  {
    return std::hypot(smooth(x + 1, y) - smooth(x - 1, y),
                      smooth(x, y + 1) - smooth(x, y - 1)) /
           2;
  }

  /** \return difference between a pixel and the maximum of its neighbours */
  double
  prominence(int x, int y) const
  {
    double largest = 0;
    for (int v = y - 1; v <= y + 1; ++v)
      for (int u = x - 1; u <= x + 1; ++u)
        if (u != x || v != y)
          largest = std::max(largest, at(u, v));
    return at(x, y) - largest;
  }

private:
  double
  smooth(int x, int y) const
  {
    double sum = 0, weights = 0;
    for (int v = -3; v <= 3; ++v)
      for (int u = -3; u <= 3; ++u) {
        const double weight = std::exp(-(u * u + v * v) / 2.0);
        const int column = std::clamp(x + u, 0, image_.width - 1);
        const int row = std::clamp(y + v, 0, image_.height - 1);
        sum += weight *
               image_.values[static_cast<std::size_t>(row * image_.width + column)];
        weights += weight;
      }
    return sum / weights;
  }

  const GreyImage& image_;
};

GreyImage
cropped(const GreyImage& image, int width, int height)
{
  GreyImage part{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      part.values.push_back(
          image.values[static_cast<std::size_t>(y * image.width + x)]);
  return part;
}

class KeypointOracle : public testing::Test {
protected:
  std::vector<std::int32_t>
  found(const KeypointSettings& settings)
  {
    return gradientMaxima(image_, has_place_, settings, counts_);
  }

  GreyImage image_ = cropped(paint(Wallpaper(1)), 150, 100);
  std::vector<std::uint8_t> has_place_ = std::vector<std::uint8_t>(15000, 1);
  KeypointCounts counts_;
};

TEST_F(KeypointOracle, maximaAreThoseOfEightNeighbours)
{
  KeypointSettings settings;
  settings.min_gradient = 4;
  settings.maximum = 100000;
  const std::vector<std::int32_t> pixels = found(settings);
  ASSERT_GT(pixels.size(), 50u);
  EXPECT_EQ(counts_.maxima, pixels.size());
  const NaiveGradient naive(image_);
  for (int y = 2; y + 2 < image_.height; ++y)
    for (int x = 2; x + 2 < image_.width; ++x) {
      const double prominence = naive.prominence(x, y), value = naive.at(x, y);
      if (std::abs(prominence) < 1e-4 || std::abs(value - 4) < 1e-4)
        continue; // depends on rounding
      EXPECT_EQ(std::binary_search(pixels.begin(), pixels.end(), y * image_.width + x),
                prominence > 0 && value > 4)
          << x << ' ' << y;
    }
}

TEST_F(KeypointOracle, pixelsWithoutPlaceAreCountedAndLeftOut)
{
  KeypointSettings settings;
  settings.maximum = 100000;
  const std::vector<std::int32_t> all = found(settings);
  for (std::size_t i = 0; i < has_place_.size(); ++i)
    has_place_[i] = i % 3 == 0;
  std::vector<std::int32_t> wanted;
  for (const std::int32_t pixel : all)
    if (pixel % 3 == 0)
      wanted.push_back(pixel);
  EXPECT_EQ(found(settings), wanted);
  EXPECT_EQ(counts_.maxima, all.size());
  EXPECT_EQ(counts_.without_place, all.size() - wanted.size());
  EXPECT_EQ(counts_.left_out, 0u);
}

/** Selects in rounds: each one takes the strongest remaining keypoint of each tile. */
std::vector<std::int32_t>
naiveChoice(std::map<std::int32_t, double> gradients, int width, std::size_t maximum)
{
  std::vector<double> sorted;
  for (const auto& [pixel, gradient] : gradients)
    sorted.push_back(gradient);
  std::sort(sorted.rbegin(), sorted.rend());
  const double minimum = sorted[maximum - 1] / 2;
  std::vector<std::int32_t> chosen;
  while (chosen.size() < maximum) {
    std::map<std::pair<int, int>, std::int32_t> best;
    for (const auto& [pixel, gradient] : gradients) {
      const std::pair cell(pixel % width / 32, pixel / width / 24);
      if (gradient >= minimum &&
          (!best.count(cell) || gradient > gradients.at(best.at(cell))))
        best[cell] = pixel;
    }
    std::vector<std::int32_t> round;
    for (const auto& [cell, pixel] : best)
      round.push_back(pixel);
    std::sort(round.begin(), round.end(), [&](std::int32_t a, std::int32_t b) {
      return gradients.at(a) > gradients.at(b);
    });
    for (const std::int32_t pixel : round) {
      if (chosen.size() < maximum)
        chosen.push_back(pixel);
      gradients.erase(pixel);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

TEST_F(KeypointOracle, cellsGiveTheirStrongestInTurn)
{
  KeypointSettings settings;
  settings.maximum = 100000;
  const NaiveGradient naive(image_);
  std::map<std::int32_t, double> gradients;
  for (const std::int32_t pixel : found(settings))
    gradients[pixel] = naive.at(pixel % image_.width, pixel / image_.width);
  for (const std::size_t maximum : {1, 10, 40, 100}) {
    ASSERT_GT(gradients.size(), maximum);
    settings.maximum = maximum;
    EXPECT_EQ(found(settings), naiveChoice(gradients, image_.width, maximum))
        << maximum;
    EXPECT_EQ(counts_.left_out, gradients.size() - maximum);
  }
}

TEST_F(KeypointOracle, alikeNeighboursAreNoStrictMaxima)
{
  // a straight edge: its gradient is constant along it
  for (std::size_t i = 0; i < image_.values.size(); ++i)
    image_.values[i] = i % 150 < 70 ? 50 : 200;
  EXPECT_TRUE(found({}).empty());
  EXPECT_EQ(counts_.maxima, 0u);
}

} // namespace
} // namespace pcl::acmap::test
