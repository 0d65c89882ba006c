#include "reading_options.h"
#include "stage_reports.h"
#include "tool.h"

#include <pcl/core/cloud_assessment.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/length_remarks.h>
#include <pcl/core/impl/map_shift.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/impl/unit_text.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace {

using namespace pcl::acmap;

std::string
describePoints(const pcl::CloudAssessmentReport& report)
{
  std::string text = std::to_string(report.points);
  if (report.columns > 0)
    text += ", " + std::to_string(report.columns) + " x " +
            std::to_string(report.points / report.columns);
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0)
      text += ", " + std::to_string(count) + " " + what;
  };
  add(report.points - report.finite_points, "not finite");
  add(report.zero_points, "at (0, 0, 0)");
  add(report.duplicate_points, "at the place of another");
  return text;
}

std::string
describeExtent(const pcl::CloudAssessmentReport& report)
{
  const Eigen::Vector3d size = report.maximum - report.minimum;
  return shortNumber(size.x()) + " x " + shortNumber(size.y()) + " x " +
         shortNumber(size.z()) + " m";
}

std::string
describeColors(const pcl::CloudAssessmentReport& report)
{
  switch (report.colors.content) {
  case pcl::ColorContent::None:
    return "none";
  case pcl::ColorContent::Empty:
    return "a field, but all points are black";
  case pcl::ColorContent::One:
    return "all points have the same";
  case pcl::ColorContent::Varied:
    break;
  }
  return "yes";
}

/** What a shell takes as one word. */
std::string
quoted(const std::string& word)
{
  const bool is_plain =
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                             "0123456789_./-+:@") == std::string::npos;
  if (is_plain)
    return word;
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + "'";
}

/** Options that state what neither the file does nor the assessment could find out.
 * \param[in] is_scale_stated by the caller */
std::string
optionsFor(const pcl::CloudAssessmentReport& report, bool is_scale_stated)
{
  if (is_scale_stated)
    return " --scale " + unitText(report.unit.value);
  return report.unit.outcome == pcl::UnitOutcome::Doubtful ? " --scale 0.001" : "";
}

void
tell(const std::string& input,
     bool is_scale_stated,
     const pcl::CloudAssessmentReport& report,
     StageLog& log)
{
  log.tell("points", describePoints(report));
  if (report.finite_points == 0)
    log.failWithNothing(input + ": no point is finite");
  log.tell("extent", describeExtent(report));
  log.tell("unit", describe(report.unit));
  if (!report.shift.isZero(0))
    log.tell("shift",
             shiftText(report.shift) +
                 " m are to be added to the coordinates of results; --shift states "
                 "others");
  log.tell("spacing",
           report.spacing > 0 ? shortNumber(1000 * report.spacing) + " mm" : "none");
  tellAssessment(report, log);
  log.tell("colours", describeColors(report));
  const std::string words = quoted(input) + optionsFor(report, is_scale_stated);
  log.tell("planes", "pcl_plane_extraction " + words + " planes.json");
  log.tell("map", "pcl_compact_mapping " + words + " -o map");
  log.tell("picture", "pcl_compact_viewer " + words);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool(
      "pcl_cloud_info",
      "Says what a cloud is: unit, up direction, sensor, spacing, noise, colours, "
      "each with its evidence.");
  std::string input;
  tool.options()
      .add_option(
          "input",
          input,
          "Point cloud (.pcd, .ply, .obj, .xyz, .txt, .csv, .pts, .ptx, .las, .e57)")
      ->type_name("CLOUD")
      ->required();
  tool.addThreads();
  addReading(tool.options(), tool.reader());
  tool.setHelp({{{"pcl_cloud_info cloud.ply",
                  "Unit, up direction, noise and more, and the commands that fit."}},
                {}});
  return tool.run(argc, argv, [&] {
    tool.requireReportWritable({input});
    const auto file = std::make_shared<pcl::PointCloudFile>();
    pcl::CloudAssessment assessment;
    const pcl::CloudRows rows = tool.reader().readRows(input, *file);
    assessment.setInputCloud(rows, file);
    assessment.setNumberOfThreads(tool.controls().threads);
    assessment.setProgressCallback(tool.controls().progress);
    assessment.compute();
    tool.log().warn(file->remarks);
    const pcl::CloudAssessmentReport& report = assessment.getReport();
    tool.log().warn(lengthRemarks(requirePoints(rows),
                                  report.spacing,
                                  report.unit.outcome == pcl::UnitOutcome::Stated));
    tell(input, tool.options().count("--scale") > 0, report, tool.log());
  });
}
