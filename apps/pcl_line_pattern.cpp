#include "line_pattern/pattern_options.h"
#include "line_pattern/pattern_show.h"
#include "output_target.h"

#include <pcl/core/image_file.h>
#include <pcl/core/output_folder.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace {

using namespace pcl::acmap;
using Json = nlohmann::ordered_json;

constexpr const char* name_start = "pattern_";

std::string
patternName(std::uint32_t index)
{
  char name[32];
  std::snprintf(name, sizeof(name), "%s%02u.png", name_start, index);
  return name;
}

/** \brief Refuses a folder with patterns of an earlier run, which would mix with the
 * new ones. */
void
requireNoPatterns(const OutputFolder& folder)
{
  requireNoneIn(folder,
                [](const std::string& name) { return name.rfind(name_start, 0) == 0; });
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
    patterns.push_back({{"file", name},
                        {"coverage", report.coverage},
                        {"redraws", report.redraws},
                        {"row_side_lobe", report.row_side_lobe},
                        {"column_side_lobe", report.column_side_lobe},
                        {"worst_row_side_lobe", report.worst_row_side_lobe},
                        {"worst_column_side_lobe", report.worst_column_side_lobe}});
  }
};

void
tellResults(Tool& tool,
            const PatternOptions& options,
            const pcl::RandomLinePattern& generator,
            const Totals& totals)
{
  const double coverage = totals.coverage / options.patterns;
  tool.details().update({{"output", options.output},
                         {"width", generator.getWidth()},
                         {"height", generator.getHeight()},
                         {"lines", options.lines},
                         {"colored", !options.grey},
                         {"minimum_angle_degrees", options.minimum_angle},
                         {"seed", options.seed},
                         {"coverage", coverage},
                         {"redraws", totals.redraws},
                         {"patterns", totals.patterns}});
  tool.tell("patterns",
            std::to_string(options.patterns) + ", " +
                std::to_string(generator.getWidth()) + " x " +
                std::to_string(generator.getHeight()) + " px, " +
                std::to_string(options.lines) + " lines each");
  tool.tell("coverage", shortNumber(100 * coverage) + " %");
  tool.tell("side lobes",
            "at most " + shortNumber(totals.row_side_lobe) + " along rows, " +
                shortNumber(totals.column_side_lobe) + " along columns, but for 1 %");
  tool.tell("redrawn", std::to_string(totals.redraws));
  tool.tell(options.is_single ? "picture" : "folder", options.output);
}

void
run(Tool& tool, PatternOptions& options)
{
  settleOutput(tool, options);
  pcl::RandomLinePattern generator = generatorOf(options);
  std::optional<OutputFolder> folder;
  if (options.is_single)
    requireWritable(options.output, {".png"}, {});
  else
    requireNoPatterns(folder.emplace(options.output));
  tool.requireReportWritable({options.output});
  PatternShow show(tool, options, generator);

  StepTimer timer(tool.report());
  Totals totals;
  pcl::RgbImage picture;
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const pcl::acmap::Progress told(progress);
    for (std::uint32_t index = 0; index < options.patterns; ++index) {
      told.tell(static_cast<double>(index) / options.patterns, "drawing");
      picture = generator.generate(index);
      totals.add(options.is_single ? options.output : patternName(index),
                 generator.getReport());
      for (const std::string& remark : generator.getReport().remarks)
        tool.warn(remark);
      if (folder)
        pcl::savePng(folder->path(patternName(index)), picture);
      show.show(picture);
    }
  });
  tool.stopIfInterrupted();
  if (folder)
    folder->commit();
  else
    pcl::savePng(options.output, picture);
  timer.finish("draw");
  tellResults(tool, options, generator, totals);
  show.tell();
  if (folder)
    tool.setReportPlace(options.output + "/report.json");
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_line_pattern",
            "Makes patterns of random lines for a projector, and shows them.");
  PatternOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { run(tool, options); });
}
