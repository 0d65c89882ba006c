#pragma once

#include <pcl/core/image_file.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Parameters of the distribution of a pattern's lines. */
struct PatternLaw {
  std::int32_t width = 1024; ///< width of the pattern, pixels
  std::int32_t height = 768;
  int lines = 200;
  int min_line_width = 2; ///< pixels
  int max_line_width = 6;
  bool colored = true;      ///< each channel has an intensity of its own
  double minimum_angle = 0; ///< between a line and the rows, radians
};

/** \brief A line as a band of pixels: those whose centres p fulfil -w/2 <= (p - c) .
 * (-sin phi, cos phi) - rho < w/2, where c is the centre of the pattern. */
struct PatternLine {
  double angle = 0;    ///< phi, from the rows, radians in [0, pi)
  double distance = 0; ///< rho, signed, pixels
  int width = 1;       ///< w, pixels
  std::array<std::uint8_t, 3> color{};
};

/** \brief Draws independent lines, in the order in which they are to be painted: phi
 * uniform with at least the minimum angle from the rows, rho uniform over the diagonal,
 * integer widths and intensities in 64..255 uniform. A line may lie outside the
 * pattern, near its corners. */
std::vector<PatternLine>
sampleLines(const PatternLaw& law, std::uint64_t seed);

/** \brief Paints a line over an image; each pixel either belongs to the line or not. */
void
paintLine(const PatternLine& line, RgbImage& image);

/** \brief Creates a black image and paints the lines in order, later ones over earlier
 * ones. */
RgbImage
paintLines(const PatternLaw& law, const std::vector<PatternLine>& lines);

/** \brief Fraction of the pixels that are not black. */
double
coverageOf(const RgbImage& image);

} // namespace pcl::acmap
