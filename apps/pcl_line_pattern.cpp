#include "command_line.h"
#include "line_pattern/pattern_options.h"
#include "output_target.h"

#include <pcl/acquisition/pattern_window.h>
#include <pcl/core/fields_json.h>
#include <pcl/core/impl/size_text.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

namespace {

using namespace pcl::acmap;
using Json = nlohmann::ordered_json;

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
  addPatternLook(tool, options);
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
      ->check(positiveNumber(86400).description(""));
}

/** \brief Decides if the output is a folder or a picture, which has one pattern. */
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

constexpr const char* name_start = "pattern_";

std::string
patternName(std::uint32_t index)
{
  char name[32];
  std::snprintf(name, sizeof(name), "%s%02u.png", name_start, index);
  return name;
}

/** \brief Opens a black window for the patterns; warns when they have to be scaled.
 * \throws BadArgumentException, IOException when there is no such monitor */
std::unique_ptr<pcl::PatternWindow>
openWindow(int number, const pcl::RandomLinePattern& generator, StageLog& log)
{
  auto window = std::make_unique<pcl::PatternWindow>(static_cast<std::size_t>(number));
  const pcl::MonitorPlace& monitor = window->getMonitor();
  if (monitor.width != generator.getWidth() || monitor.height != generator.getHeight())
    log.warn("monitor " + monitor.name + " has " + sizeText(monitor) +
             " px, the patterns " +
             sizeText(generator.getWidth(), generator.getHeight()) +
             " px: they are shown scaled");
  return window;
}

/** \brief Waits, or throws CancelledException when the user interrupts it. */
void
holdFor(std::chrono::duration<double> time)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + time;
  while (Clock::now() < end) {
    stopIfInterrupted();
    const std::chrono::duration<double> left = end - Clock::now();
    std::this_thread::sleep_for(std::min(left, std::chrono::duration<double>(0.05)));
  }
}

/** \brief Statistics over all patterns. */
struct Totals {
  double coverage = 0;
  int redraws = 0;
  double row_side_lobe = 0;
  double column_side_lobe = 0;
  Json patterns = Json::array();

  void
  add(const std::string& name, const pcl::RandomLinePatternReport& report)
  {
    coverage += report.coverage;
    redraws += report.redraws;
    row_side_lobe = std::max(row_side_lobe, report.row_side_lobe);
    column_side_lobe = std::max(column_side_lobe, report.column_side_lobe);
    Json pattern = {{"file", name}};
    pattern.update(fieldsOf(report, {{"lines"}}));
    patterns.push_back(std::move(pattern));
  }
};

void
tellResults(const PatternOptions& options,
            const pcl::RandomLinePattern& generator,
            const Totals& totals,
            const pcl::PatternWindow* window,
            StageLog& log)
{
  const double coverage = totals.coverage / options.patterns;
  constexpr double degrees = 180 / 3.14159265358979323846, digits = 1e6;
  const double angle = degrees * generator.getMinimumAngle();
  log.details = {{"output", options.output},
                 {"width", generator.getWidth()},
                 {"height", generator.getHeight()},
                 {"lines", generator.getNumberOfLines()},
                 {"colored", generator.getColored()},
                 {"minimum_angle_degrees", std::round(digits * angle) / digits},
                 {"seed", generator.getSeed()},
                 {"coverage", coverage},
                 {"redraws", totals.redraws},
                 {"patterns", totals.patterns}};
  log.tell("patterns",
           std::to_string(options.patterns) + ", " +
               sizeText(generator.getWidth(), generator.getHeight()) + " px, " +
               std::to_string(generator.getNumberOfLines()) + " lines each");
  log.tell("coverage", shortNumber(100 * coverage) + " %");
  log.tell("side lobes",
           "at most " + shortNumber(totals.row_side_lobe) + " along rows, " +
               shortNumber(totals.column_side_lobe) + " along columns, but for 1 %");
  log.tell("redrawn", std::to_string(totals.redraws));
  log.tell(options.is_single ? "picture" : "folder", options.output);
  if (!window)
    return;
  const pcl::MonitorPlace& monitor = window->getMonitor();
  log.tell("shown", "on monitor " + monitor.name + ", " + sizeText(monitor) + " px");
  log.details["monitor"] = {{"name", monitor.name},
                            {"x", monitor.x},
                            {"y", monitor.y},
                            {"width", monitor.width},
                            {"height", monitor.height}};
}

void
run(Tool& tool, PatternOptions& options)
{
  settleOutput(tool, options);
  pcl::RandomLinePattern generator = generatorOf(options);
  std::optional<OutputFolder> folder;
  if (options.is_single)
    requireWritable(options.output, {".png"}, {});
  else // patterns of an earlier run would mix with the new ones
    requireNoneIn(folder.emplace(options.output), [](const std::string& name) {
      return name.rfind(name_start, 0) == 0;
    });
  tool.requireReportWritable({options.output});
  std::unique_ptr<pcl::PatternWindow> window;
  if (options.show)
    window = openWindow(options.monitor, generator, tool.log());

  StepTimer timer(tool.log().report);
  Totals totals;
  pcl::RgbImage picture;
  const Progress progress(tool.controls().progress);
  for (std::uint32_t index = 0; index < options.patterns; ++index) {
    progress.tell(static_cast<double>(index) / options.patterns, "drawing");
    picture = generator.generate(index);
    totals.add(options.is_single ? options.output : patternName(index),
               generator.getReport());
    for (const std::string& remark : generator.getReport().remarks)
      tool.log().warn(remark);
    if (folder)
      pcl::savePng(folder->path(patternName(index)), picture);
    if (window) {
      window->show(picture);
      holdFor(std::chrono::duration<double>(options.hold));
    }
  }
  stopIfInterrupted();
  if (folder)
    folder->commit();
  else
    pcl::savePng(options.output, picture);
  timer.finish("draw");
  tellResults(options, generator, totals, window.get(), tool.log());
  if (folder)
    tool.setOutputFolder(options.output);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_line_pattern",
            "Makes patterns of random lines for a projector, and shows them.");
  PatternOptions options;
  addOptions(tool, options);
  tool.setHelp({{{"pcl_line_pattern pattern.png", "One pattern as an image."},
                 {"pcl_line_pattern patterns --show",
                  "Makes ten patterns, and shows each full screen."}},
                {}});
  return tool.run(argc, argv, [&] { run(tool, options); });
}
