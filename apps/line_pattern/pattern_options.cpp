#include "pattern_options.h"

#include "command_line.h"
#include "output_target.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

void
addShowing(CLI::App& app, PatternOptions& options)
{
  CLI::Option* const show =
      app.add_flag("--show",
                   options.show,
                   "Show each pattern while it is written, full screen; needs an X "
                   "server");
  app.add_option("--monitor", options.monitor, "Which monitor, counted from 0")
      ->type_name("K")
      ->needs(show)
      ->check(CLI::Range(0, 1000).description(""));
  app.add_option("--hold", options.hold, "How long each pattern stays, seconds")
      ->type_name("SECONDS")
      ->needs(show)
      ->check(positiveNumber().description(""))
      ->check(CLI::Range(0.0, 86400.0).description(""));
}

} // namespace

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

void
addOptions(Tool& tool, PatternOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "output",
         options.output,
         "Folder for pattern_00.png and so on, or a .png for the first one alone")
      ->type_name("OUT_DIR|OUT.png")
      ->required();
  app.add_option("--patterns", options.patterns, "How many patterns; a .png has one")
      ->type_name("N")
      ->check(CLI::Range(1, 1000).description(""));
  app.add_option("--size", options.size, "Width and height of the projector, pixels")
      ->type_name("WxH");
  addPatternLook(app, options);
  tool.addSeed(options.seed);
  addShowing(app, options);
}

void
settleOutput(Tool& tool, PatternOptions& options)
{
  options.is_single = endingOf(options.output) == ".png";
  if (!options.is_single)
    return;
  if (tool.options().get_option("--patterns")->count() > 0 && options.patterns != 1)
    throw UsageError(options.output + ": holds one pattern; name a folder for " +
                     std::to_string(options.patterns));
  options.patterns = 1;
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
  generator.setMinimumAngle(degree * options.minimum_angle);
  generator.setSeed(options.seed);
  return generator;
}

} // namespace pcl::acmap
