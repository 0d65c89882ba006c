#include "line_raster.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap {
namespace {

// Normals and distances are rounded to multiples of 1 / fixed_one. All further
// computations are exact, so that rounding differences of a library's sine do not
// change pixels.
constexpr double fixed_one = 1 << 20;

std::int64_t
toFixed(double value)
{
  return std::llround(value * fixed_one);
}

/** n / d, rounded up; d > 0. */
std::int64_t
ceiledQuotient(std::int64_t n, std::int64_t d)
{
  return n >= 0 ? (n + d - 1) / d : -(-n / d);
}

/** \brief The band least <= x X + y Y < end, where X and Y are twice the pixel
 * coordinates relative to the centre of the image. */
struct Band {
  std::int64_t x;
  std::int64_t y;
  std::int64_t least;
  std::int64_t end;
};

Band
bandOf(const PatternLine& line)
{
  const std::int64_t half_width = toFixed(line.width);
  const std::int64_t distance = 2 * toFixed(line.distance);
  Band band{-toFixed(std::sin(line.angle)),
            toFixed(std::cos(line.angle)),
            distance - half_width,
            distance + half_width};
  return band;
}

/** \brief Columns [first, second) of the band in a row; empty if first >= second. */
std::pair<std::int64_t, std::int64_t>
columnsOf(const Band& band, std::int64_t doubled_row, std::int32_t width)
{
  const std::int64_t least = band.least - band.y * doubled_row;
  const std::int64_t end = band.end - band.y * doubled_row;
  if (band.x == 0)
    return {0, least <= 0 && 0 < end ? width : 0};
  // x (2 column - (width - 1)) is within [least, end); x < 0 reverses the bounds
  const std::int64_t step = 2 * std::abs(band.x);
  const std::int64_t middle = std::abs(band.x) * (width - 1);
  const auto [from, to] =
      band.x > 0 ? std::pair{least, end} : std::pair{-end + 1, -least + 1};
  return {std::max<std::int64_t>(0, ceiledQuotient(from + middle, step)),
          std::min<std::int64_t>(width, ceiledQuotient(to + middle, step))};
}

} // namespace

void
paintLine(const PatternLine& line, RgbImage& image)
{
  const Band band = bandOf(line);
  for (std::int32_t row = 0; row < image.height; ++row) {
    const auto [first, last] =
        columnsOf(band, 2 * std::int64_t{row} - (image.height - 1), image.width);
    for (std::int64_t column = first; column < last; ++column)
      std::copy(line.color.begin(),
                line.color.end(),
                image.at(static_cast<std::int32_t>(column), row));
  }
}

RgbImage
paintLines(const PatternLaw& law, const std::vector<PatternLine>& lines)
{
  RgbImage image{law.width, law.height, {}};
  image.values.resize(3 * static_cast<std::size_t>(law.width) *
                      static_cast<std::size_t>(law.height));
  for (const PatternLine& line : lines)
    paintLine(line, image);
  return image;
}

double
coverageOf(const RgbImage& image)
{
  std::size_t lit = 0;
  for (std::size_t i = 0; i < image.values.size(); i += 3)
    lit += image.values[i] | image.values[i + 1] | image.values[i + 2] ? 1 : 0;
  return static_cast<double>(lit) / (static_cast<double>(image.values.size()) / 3);
}

} // namespace pcl::acmap
