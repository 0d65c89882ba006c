#include "pattern_lines.h"

#include <pcl/core/random.h>

#include <cmath>

namespace pcl::acmap {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int min_intensity = 64;
constexpr int max_intensity = 255;

int
uniformInteger(Random& random, int least, int most)
{
  return static_cast<int>(std::floor(random.uniform(least, most + 1.0)));
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

} // namespace pcl::acmap
