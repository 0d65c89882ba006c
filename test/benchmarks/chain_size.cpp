#include "chain_runs.h"
#include "chain_tables.h"
#include "markdown_row.h"
#include "temporary_folder.h"
#include "units.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

/** Time that a camera with 14 shots per second needs for the patterns of 106
 * observations. */
constexpr double capture = 106 * 10 / 14.0; // seconds

void
printStages(const nlohmann::ordered_json& report)
{
  printHead({"stage", "seconds", "of them"});
  double sum = 0;
  for (const auto& stage : report.at("stages")) {
    double seconds = 0;
    std::string steps;
    for (const auto& [name, time] : stage.at("seconds").items()) {
      seconds += time.get<double>();
      std::ostringstream step;
      step.precision(2);
      step << std::fixed << (steps.empty() ? "" : ", ") << name << " "
           << time.get<double>();
      steps += step.str();
    }
    sum += seconds;
    MarkdownRow().text(stage.at("name")).number(seconds, 1).text(steps).print();
  }
  constexpr double giga = 1e9;
  MarkdownRow().text("all").number(sum, 1).text("").print();
  std::cout << '\n';
  printHead({"camera, s", "processing : camera", "peak memory, GB"});
  MarkdownRow()
      .number(capture, 1)
      .atMost(sum / capture, 2, 2)
      .number(report.at("peak_memory_bytes").get<double>() / giga, 2)
      .print();
  std::cout << '\n';
}

void
printTruth(const nlohmann::ordered_json& truth)
{
  const auto figure = [&](const char* name) { return truth.at(name).get<double>(); };
  printHead({"main planes",
             "mean angle, degrees",
             "largest",
             "mean offset, mm",
             "largest",
             "ATE before, m",
             "after",
             "after : before",
             "compactness"});
  MarkdownRow()
      .text(truth.at("main_planes_found").dump() + " of " +
            truth.at("main_planes").dump())
      .atMost(figure("mean_angle_deg"), 0.2, 3)
      .number(figure("largest_angle_deg"), 3)
      .atMost(milli * figure("mean_offset_m"), 10, 2)
      .number(milli * figure("largest_offset_m"), 2)
      .number(figure("ate_before_m"), 4)
      .number(figure("ate_after_m"), 4)
      .atMost(figure("ate_after_m") / figure("ate_before_m"), 0.5, 2)
      .atLeast(figure("compactness"), 200, 0)
      .print();
  std::cout << '\n';
}

} // namespace

void
printChainSize()
{
  const test::TemporaryFolder folder;
  const std::string session = folder.path("session"), map = folder.path("map");
  runWhole(ACMAP_SIMULATED_RIG, {"-o", session, "--scene", "corridor_survey"});
  runWhole(ACMAP_COMPACT_MAPPING,
           {session, "-o", map, "--no-pictures", "--truth", session});
  const auto report =
      nlohmann::ordered_json::parse(std::ifstream(map + "/report.json"));
  std::cout << "### The paper's size: 106 observations under 10 patterns\n\n";
  printStages(report);
  printTruth(report.at("truth"));
}

} // namespace pcl::acmap::bench
