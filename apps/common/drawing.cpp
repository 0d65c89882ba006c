#include "drawing.h"

#include <pcl/core/image_file.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace pcl::acmap {

namespace {

// Glyphs of 5 rows of 3 pixels; the upper left pixel is the highest bit. They are drawn
// in double size.
constexpr int glyph_rows = 5, glyph_columns = 3, glyph_scale = 2;
constexpr std::array<std::uint16_t, 10> digits = {
    075557, 026227, 071747, 071717, 055711, 074717, 074757, 071111, 075757, 075717};
constexpr std::array<std::uint16_t, 26> letters = {
    075755, 065656, 074447, 065556, 074647, 074644, 074557, 055755, 072227,
    011157, 055655, 044447, 057755, 065555, 075557, 075744, 075571, 075655,
    074717, 072222, 055557, 055552, 055775, 055255, 055222, 071247};

std::uint16_t
glyphOf(char letter)
{
  const auto code = static_cast<unsigned char>(letter);
  if (std::isdigit(code))
    return digits[static_cast<std::size_t>(letter - '0')];
  if (std::isalpha(code))
    return letters[static_cast<std::size_t>(std::toupper(code) - 'A')];
  switch (letter) {
  case '.':
    return 000002;
  case '-':
    return 000700;
  case '+':
    return 002720;
  case '/':
    return 011244;
  default:
    return 0;
  }
}

void
mix(std::uint8_t* pixel, const Color& color, double share)
{
  for (std::size_t c = 0; c < color.size(); ++c)
    pixel[c] = static_cast<std::uint8_t>(
        std::lround(pixel[c] + share * (color[c] - pixel[c])));
}

double
distanceToSegment(const Eigen::Vector2d& point,
                  const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to)
{
  const Eigen::Vector2d along = to - from;
  const double squared = along.squaredNorm();
  const double t =
      squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - from - t * along).norm();
}

/** \brief Range of pixels, limited to an image side of that length. */
struct Span {
  int first, last;
};

Span
spanOf(double a, double b, double reach, int pixels)
{
  const double most = pixels - 1;
  return {static_cast<int>(std::clamp(std::min(a, b) - reach, 0.0, most + 1)),
          static_cast<int>(std::clamp(std::ceil(std::max(a, b) + reach), -1.0, most))};
}

} // namespace

RgbImage
whiteImage(int width, int height)
{
  RgbImage image;
  image.width = width;
  image.height = height;
  image.values.assign(
      3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  return image;
}

void
drawLine(RgbImage& image,
         const Eigen::Vector2d& from,
         const Eigen::Vector2d& to,
         double width,
         const Color& color)
{
  if (!from.allFinite() || !to.allFinite())
    return;
  const double reach = 0.5 * width + 0.5;
  const Span columns = spanOf(from.x(), to.x(), reach, image.width);
  const Span rows = spanOf(from.y(), to.y(), reach, image.height);
  for (int row = rows.first; row <= rows.last; ++row)
    for (int column = columns.first; column <= columns.last; ++column) {
      const double distance = distanceToSegment({column, row}, from, to);
      const double share = std::clamp(reach - distance, 0.0, 1.0);
      if (share > 0)
        mix(image.at(column, row), color, share);
    }
}

void
drawText(
    RgbImage& image, int column, int row, const std::string& text, const Color& color)
{
  for (const char letter : text) {
    const std::uint16_t glyph = glyphOf(letter);
    for (int y = 0; y < glyph_scale * glyph_rows; ++y)
      for (int x = 0; x < glyph_scale * glyph_columns; ++x) {
        const int bit =
            y / glyph_scale * glyph_columns + x / glyph_scale; // from the upper left
        const bool inside = column + x >= 0 && column + x < image.width &&
                            row + y >= 0 && row + y < image.height;
        if (inside && (glyph >> (glyph_rows * glyph_columns - 1 - bit) & 1) != 0)
          std::copy(color.begin(), color.end(), image.at(column + x, row + y));
      }
    column += text_advance;
  }
}

void
paste(const RgbImage& from, int column, int row, RgbImage& to)
{
  for (int y = 0; y < from.height; ++y)
    std::copy_n(from.at(0, y), 3 * from.width, to.at(column, row + y));
}

double
roundLength(double most)
{
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most)
      return factor * power;
  return power;
}

} // namespace pcl::acmap
