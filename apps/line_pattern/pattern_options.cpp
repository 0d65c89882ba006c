#include "pattern_options.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {

void
addPatternLook(CLI::App& app, PatternOptions& options)
{
  app.add_option("--lines", options.lines, "Lines of a pattern, at most 10000")
      ->type_name("N");
  app.add_flag("--grey", options.grey, "Grey lines in place of coloured ones");
  app.add_option("--min-angle",
                 options.minimum_angle,
                 "Least angle between lines and rows, degrees; 15 for rigs without a "
                 "vertical pair of cameras")
      ->type_name("DEG")
      ->check(CLI::Range(0.0, 85.0).description(""));
}

RandomLinePattern
generatorOf(const PatternOptions& options)
{
  RandomLinePattern generator;
  const auto size = crossedNumbers(options.size);
  if (!size)
    throw UsageError("--size: " + options.size + " is not of the form WxH");
  generator.setSize((*size)[0], (*size)[1]);
  generator.setNumberOfLines(options.lines);
  generator.setColored(!options.grey);
  constexpr double degree = 3.14159265358979323846 / 180;
  generator.setMinimumAngle(degree * options.minimum_angle);
  generator.setSeed(options.seed);
  return generator;
}

} // namespace pcl::acmap
