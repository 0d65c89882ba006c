#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief What a pattern's lines are drawn from. */
struct PatternLaw {
  std::int32_t width = 1024; ///< of the pattern, pixels
  std::int32_t height = 768;
  int lines = 200;
  int least_line_width = 2; ///< pixels
  int most_line_width = 6;
  bool colored = true;      ///< each channel with an intensity of its own
  double minimum_angle = 0; ///< between a line and the rows, radians
};

/** \brief A band of pixels: those whose centres p have
 * -w/2 <= (p - c) . (-sin phi, cos phi) - rho < w/2, c the middle of the pattern. */
struct PatternLine {
  double angle = 0;    ///< phi, from the rows, radians in [0, pi)
  double distance = 0; ///< rho, signed, pixels
  int width = 1;       ///< w, pixels
  std::array<std::uint8_t, 3> color{};
};

/** \brief Independent lines, in the order in which they are to be painted: phi uniform
 * at least the minimum angle from the rows, rho uniform over the diagonal, whole widths
 * and intensities 64..255 uniform. A line may miss the pattern's corners. */
std::vector<PatternLine>
sampleLines(const PatternLaw& law, std::uint64_t seed);

} // namespace pcl::acmap
