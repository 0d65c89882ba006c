#include "pattern_lines.h"

#include <pcl/core/random.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int min_intensity = 64;
constexpr int max_intensity = 255;

int
uniformInteger(Random& random, int minimum, int maximum)
{
  return static_cast<int>(std::floor(random.uniform(minimum, maximum + 1.0)));
}

std::array<std::uint8_t, 3>
sampleColor(Random& random, bool colored)
{
  std::array<std::uint8_t, 3> color{};
  color.fill(
      static_cast<std::uint8_t>(uniformInteger(random, min_intensity, max_intensity)));
  if (colored)
    for (std::size_t channel = 1; channel < 3; ++channel)
      color[channel] = static_cast<std::uint8_t>(
          uniformInteger(random, min_intensity, max_intensity));
  return color;
}

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
  std::int64_t minimum;
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
  const std::int64_t minimum = band.minimum - band.y * doubled_row;
  const std::int64_t end = band.end - band.y * doubled_row;
  if (band.x == 0)
    return {0, minimum <= 0 && 0 < end ? width : 0};
  // x (2 column - (width - 1)) is within [least, end); x < 0 reverses the bounds
  const std::int64_t step = 2 * std::abs(band.x);
  const std::int64_t middle = std::abs(band.x) * (width - 1);
  const auto [from, to] =
      band.x > 0 ? std::pair{minimum, end} : std::pair{-end + 1, -minimum + 1};
  return {std::max<std::int64_t>(0, ceiledQuotient(from + middle, step)),
          std::min<std::int64_t>(width, ceiledQuotient(to + middle, step))};
}

} // namespace

std::vector<PatternLine>
sampleLines(const PatternLaw& law, std::uint64_t seed)
{
  Random random(seed);
  const double width = law.width;
  const double height = law.height;
  const double half_diagonal = 0.5 * std::sqrt(width * width + height * height);
  std::vector<PatternLine> lines(static_cast<std::size_t>(law.lines));
  for (PatternLine& line : lines) {
    line.angle = random.uniform(law.minimum_angle, pi - law.minimum_angle);
    line.distance = random.uniform(-half_diagonal, half_diagonal);
    line.width = uniformInteger(random, law.min_line_width, law.max_line_width);
    line.color = sampleColor(random, law.colored);
  }
  return lines;
}

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
