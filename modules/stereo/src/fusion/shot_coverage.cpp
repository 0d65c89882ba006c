#include "shot_coverage.h"

#include <pcl/core/impl/parallel.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

constexpr std::uint32_t unit = 16; // per grey level: the sum of the weights

static_assert(ShotCoverage::max_shots * (255 * unit) * (255 * unit) <= 4294967295U);

/** \brief Reads the grey levels of a row; the first and the last pixel are repeated
 * outside the row. */
void
readRow(const CameraImage& image, int row, std::uint16_t* grey)
{
  const auto width = static_cast<std::size_t>(image.width);
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::uint8_t* const from =
      image.values.data() + static_cast<std::size_t>(row) * width * channels;
  if (channels == 1)
    std::copy_n(from, width, grey + 1);
  else
    for (std::size_t i = 0; i < width; ++i)
      grey[i + 1] = static_cast<std::uint16_t>(
          (from[3 * i] + 2 * from[3 * i + 1] + from[3 * i + 2] + 2) / 4);
  grey[0] = grey[1];
  grey[width + 1] = grey[width];
}

} // namespace

ShotCoverage::ShotCoverage(int width, int height)
: width_(width)
, height_(height)
, last_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
, sums_(last_.size())
, squares_(last_.size())
{}

void
ShotCoverage::smooth(const CameraImage& image,
                     std::vector<std::uint16_t>& smoothed) const
{
  constexpr int rows = 32;
  const auto width = static_cast<std::size_t>(width_);
  const auto smoothRows = [&](int begin, int end) {
    std::vector<std::uint16_t> grey(3 * (width + 2)), sums(width + 2);
    const auto greyOf = [&](int row) {
      const auto there = static_cast<std::size_t>(std::clamp(row, 0, height_ - 1));
      return grey.data() + there % 3 * (width + 2);
    };
    readRow(image, std::max(begin - 1, 0), greyOf(begin - 1));
    readRow(image, begin, greyOf(begin));
    for (int row = begin; row < end; ++row) {
      if (row + 1 < height_)
        readRow(image, row + 1, greyOf(row + 1));
      const std::uint16_t *const above = greyOf(row - 1), *const here = greyOf(row),
                                 *const below = greyOf(row + 1);
      for (std::size_t i = 0; i < width + 2; ++i)
        sums[i] = static_cast<std::uint16_t>(above[i] + 2 * here[i] + below[i]);
      std::uint16_t* const to = smoothed.data() + static_cast<std::size_t>(row) * width;
      for (std::size_t i = 0; i < width; ++i)
        to[i] = static_cast<std::uint16_t>(sums[i] + 2 * sums[i + 1] + sums[i + 2]);
    }
  };
  oneapi::tbb::parallel_for(0, (height_ + rows - 1) / rows, [&](int block) {
    smoothRows(block * rows, std::min((block + 1) * rows, height_));
  });
}

void
ShotCoverage::setDark(const CameraImage& image)
{
  dark_.resize(last_.size());
  smooth(image, dark_);
}

void
ShotCoverage::add(const CameraImage& image)
{
  smooth(image, last_);
  parallelForChunks(last_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t value = last_[i];
      sums_[i] += value;
      squares_[i] += value * value;
    }
  });
  ++shots_;
}

double
ShotCoverage::share(double deviation) const
{
  const bool with_dark = shots_ == 1 && !dark_.empty();
  const double samples = shots_ + (with_dark ? 1 : 0);
  if (samples < 2)
    return 0;
  const double minimum = unit * deviation * samples;
  // These are integers below 2^53, which doubles represent exactly.
  const auto isToldApart = [&](std::size_t i) {
    const double dark = with_dark ? dark_[i] : 0;
    const double sum = sums_[i] + dark;
    return samples * (squares_[i] + dark * dark) - sum * sum >= minimum * minimum;
  };
  const std::size_t told_apart = parallelReduceChunks(
      last_.size(),
      std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t i = begin; i < end; ++i)
          count += isToldApart(i) ? 1 : 0;
        return count;
      },
      [](std::size_t& all, std::size_t count) { all += count; });
  return static_cast<double>(told_apart) / static_cast<double>(last_.size());
}

} // namespace pcl::acmap
