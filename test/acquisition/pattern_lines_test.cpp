#include "pattern/pattern_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace pcl::acmap::test {
namespace {

std::vector<PatternLine>
manyLines(const PatternLaw& changed = {})
{
  PatternLaw law = changed;
  law.lines = 40000;
  return sampleLines(law, 17);
}

/** \brief Chi-square statistic of a histogram over [least, most) for a uniform
 * distribution. */
double
chiSquare(const std::vector<PatternLine>& lines,
          double minimum,
          double maximum,
          int bins,
          const std::function<double(const PatternLine&)>& valueOf)
{
  std::vector<double> counts(static_cast<std::size_t>(bins));
  for (const PatternLine& line : lines) {
    const double bin =
        std::floor((valueOf(line) - minimum) / (maximum - minimum) * bins);
    if (bin < 0 || bin >= bins)
      return std::numeric_limits<double>::infinity();
    ++counts[static_cast<std::size_t>(bin)];
  }
  const double expected = static_cast<double>(lines.size()) / bins;
  double sum = 0;
  for (const double count : counts)
    sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/** \brief The 99.9 % quantile of chi-square (Wilson and Hilferty). */
double
limitOf(int bins)
{
  const double freedom = bins - 1;
  const double part = 2 / (9 * freedom);
  return freedom * std::pow(1 - part + 3.09 * std::sqrt(part), 3);
}

TEST(PatternLines, AnglesAndDistancesAreUniform)
{
  const auto lines = manyLines();
  const auto angle = [](const PatternLine& line) { return line.angle; };
  const auto distance = [](const PatternLine& line) { return line.distance; };
  EXPECT_LT(chiSquare(lines, 0, M_PI, 40, angle), limitOf(40));
  EXPECT_LT(chiSquare(lines, -640, 640, 40, distance), limitOf(40));
  // both are independent: all cells of their joint histogram are equally likely
  const auto both = [](const PatternLine& line) {
    const double column = std::floor(line.angle / M_PI * 8);
    return column + (line.distance + 640) / 1280;
  };
  EXPECT_LT(chiSquare(lines, 0, 8, 64, both), limitOf(64));
}

TEST(PatternLines, WidthsAndIntensitiesAreUniformWholeNumbers)
{
  const auto lines = manyLines();
  EXPECT_LT(chiSquare(lines, 2, 7, 5, [](const PatternLine& l) { return l.width; }),
            limitOf(5));
  for (const std::size_t channel : {0, 1, 2})
    EXPECT_LT(chiSquare(lines,
                        64,
                        256,
                        192,
                        [=](const PatternLine& l) { return l.color[channel]; }),
              limitOf(192));
}

TEST(PatternLines, ChannelsAreIndependentOrEqual)
{
  std::size_t equal = 0;
  for (const PatternLine& line : manyLines())
    equal += line.color[0] == line.color[1] ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(equal), 40000.0 / 192, 60);
  PatternLaw grey;
  grey.colored = false;
  for (const PatternLine& line : manyLines(grey)) {
    ASSERT_EQ(line.color[0], line.color[1]);
    ASSERT_EQ(line.color[0], line.color[2]);
  }
}

TEST(PatternLines, KeepOffTheRowsWhereAskedTo)
{
  PatternLaw law;
  law.minimum_angle = 0.3;
  EXPECT_LT(chiSquare(manyLines(law),
                      0.3,
                      M_PI - 0.3,
                      40,
                      [](const PatternLine& line) { return line.angle; }),
            limitOf(40));
}

} // namespace
} // namespace pcl::acmap::test
