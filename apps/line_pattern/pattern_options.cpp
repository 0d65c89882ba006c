#include "pattern_options.h"

#include "setter_option.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {

void
addPatternLook(Tool& tool, PatternOptions& options)
{
  CLI::App& app = tool.options();
  RandomLinePattern& generator = options.generator;
  addSetter(app,
            "--lines",
            generator,
            &RandomLinePattern::setNumberOfLines,
            &RandomLinePattern::getNumberOfLines,
            "Lines of a pattern, at most 10000",
            "N");
  addSwitch(app,
            "--grey",
            generator,
            &RandomLinePattern::setColored,
            false,
            "Grey lines in place of coloured ones");
  constexpr double degree = 3.14159265358979323846 / 180;
  addSetter(app,
            "--min-angle",
            generator,
            &RandomLinePattern::setMinimumAngle,
            &RandomLinePattern::getMinimumAngle,
            "Least angle between lines and rows, degrees; 15 for rigs without a "
            "vertical pair of cameras",
            "DEG",
            degree);
  tool.addSeed(generator.getSeed(),
               [&generator](std::uint64_t seed) { generator.setSeed(seed); });
}

RandomLinePattern
generatorOf(const PatternOptions& options)
{
  RandomLinePattern generator = options.generator;
  const auto size = crossedNumbers(options.size);
  if (!size)
    throw UsageError("--size: " + options.size + " is not of the form WxH");
  generator.setSize((*size)[0], (*size)[1]);
  return generator;
}

} // namespace pcl::acmap
