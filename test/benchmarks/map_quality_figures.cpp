#include "bench.h"
#include "faulty_sessions.h"
#include "run_tool.h"
#include "temporary_folder.h"

#include <pcl/core/map_file.h>
#include <pcl/pipeline/map_comparison.h>
#include <pcl/pipeline/map_quality.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

// The heading of reports against the truth: small maps of simulated recordings with drawn faults.

namespace pcl::acmap::bench {
namespace {

/** A kind of recording, and whether the thresholds were tuned with it. */
struct FaultKind {
  RecordingFault fault;
  bool is_tuned;
};

const std::vector<FaultKind>&
kinds()
{
  static const std::vector<FaultKind> all = {
      {{"exact"}, true},
      {{"drift × 1", 1}, true},
      {{"drift × 4", 4}, true},
      {{"drift × 1, gap", 1, 0.3}, true},
      {{"depth × 1.02", 0, 0, false, 1.02}, true},
      {{"drift × 2", 2}, false},
      {{"drift × 8", 8}, false},
      {{"glass", 0, 0, true}, false},
      {{"drift × 3, glass, gap", 3, 0.2, true}, false},
      {{"all × 1.02", 0, 0, false, 1.02, 1.02}, false}};
  return all;
}

/** A map as its report judges it, and as it is; undecidable: no evidence of the map can tell. */
struct JudgedMap {
  std::string kind;
  bool is_tuned = false, is_good = false, is_undecidable = false;
  std::string heading; ///< empty: no map
};

/** All main planes that were found are within 0.3 degrees and 2 cm, these are most of them, and the
 * poses within 5 cm. */
bool
isGood(const MapDeviation& map)
{
  constexpr double angle = 0.3, offset = 0.02, ate = 0.05, share = 0.75;
  return static_cast<double>(map.found) >=
             share * static_cast<double>(map.planes.size()) &&
         map.largest_angle <= angle && map.largest_offset <= offset &&
         map.ate_after <= ate;
}

nlohmann::json
loadJson(const std::string& path)
{
  std::ifstream file(path);
  return nlohmann::json::parse(file, nullptr, false);
}

double
valueOf(const nlohmann::json& quality, const char* figure)
{
  const auto& value = quality.at(figure).at("value");
  return value.is_number() ? value.get<double>() : no_reach;
}

JudgedMap
judge(const std::string& folder,
      const std::string& session,
      const FaultKind& kind,
      const std::string& name)
{
  JudgedMap judged = {kind.fault.name, kind.is_tuned, false, false, ""};
  judged.is_undecidable = kind.fault.pose_scale != 1;
  const nlohmann::json report = loadJson(folder + "/report.json");
  if (!report.is_object() || !report.contains("quality")) {
    Row() << name << kind.fault.name << "no map";
    return judged;
  }
  const nlohmann::json& quality = report.at("quality");
  const SessionTruth truth = loadSessionTruth(session);
  const CompactMap map = loadMapFile(folder + "/map.json");
  const MapDeviation truly =
      compareWithTruth(map, mappedTrajectory(map, truth), truth).aligned;
  judged.is_good = isGood(truly);
  judged.heading = quality.at("outcome").get<std::string>();
  Row() << name << kind.fault.name << (judged.is_good ? "good" : "bad")
        << judged.heading << figure(1000 * valueOf(quality, "sharpness"), 1)
        << figure(100 * valueOf(quality, "coverage"), 0)
        << figure(100 * valueOf(quality, "rays"), 1)
        << figure(100 * valueOf(quality, "overlap"), 0)
        << quality.value("verdict", no_value)
        << std::to_string(truly.found) + " of " + std::to_string(truly.planes.size())
        << figure(truly.largest_angle, 2) << figure(1000 * truly.largest_offset, 1)
        << figure(1000 * truly.ate_after, 1);
  return judged;
}

void
addRow(const std::string& name,
       const std::vector<JudgedMap>& maps,
       bool (*belongs)(const JudgedMap&),
       bool has_reach)
{
  std::array<std::array<std::size_t, 4>, 2> counts{};
  std::array<std::size_t, 2> sums{};
  for (const JudgedMap& map : maps) {
    if (!belongs(map) || map.heading.empty())
      continue;
    const auto* const heading =
        std::find(map_quality_names.begin(), map_quality_names.end(), map.heading);
    ++counts[map.is_good ? 0 : 1]
            [static_cast<std::size_t>(heading - map_quality_names.begin())];
    ++sums[map.is_good ? 0 : 1];
  }
  Row row;
  row << name;
  for (const std::size_t side : {0, 1}) {
    row << sums[side];
    for (std::size_t heading = 0; heading < 4; ++heading)
      if (has_reach && side == 1 && heading == 0)
        row << atMost(counts[side][heading], 0, 0);
      else if (has_reach && side == 0 && heading == 2)
        row << atMost(counts[side][heading], 0.1 * static_cast<double>(sums[side]), 0);
      else
        row << counts[side][heading];
  }
}

/** Maps of ACMAP_QUALITY_SEEDS seeds (default 2) of three scenes; they stay in ACMAP_QUALITY_FOLDER if
 * it is set, and are taken from there if they are in it already. */
void
printHeadings()
{
  const char* const kept = std::getenv("ACMAP_QUALITY_FOLDER");
  const char* const seeds = std::getenv("ACMAP_QUALITY_SEEDS");
  const test::TemporaryFolder temporary;
  const std::string root = kept ? kept : temporary.path("maps");
  std::filesystem::create_directories(root);
  printHead("map | kind | truth | heading | sharpness, mm | coverage, % | rays, % | "
            "overlap, % | verdict | main planes | largest angle, ° | "
            "largest offset, mm | ATE, mm");
  std::vector<JudgedMap> maps;
  for (const char* scene : {"room", "office", "l_corridor"})
    for (int seed = 1; seed <= (seeds ? std::atoi(seeds) : 2); ++seed) {
      const std::string name = scene + (" " + std::to_string(seed));
      const std::string session = root + "/" + scene + "_" + std::to_string(seed);
      if (!std::filesystem::exists(session))
        simulateSession(session, scene, seed, true);
      for (std::size_t kind = 0; kind < kinds().size(); ++kind) {
        const std::string views = session + "_views_" + std::to_string(kind),
                          map = session + "_map_" + std::to_string(kind);
        if (!std::filesystem::exists(views))
          writeFaulty(views, session, kinds()[kind].fault, 100 * seed + 7);
        if (!std::filesystem::exists(map))
          test::runTool(ACMAP_COMPACT_MAPPING,
                        {views,
                         "-o",
                         map,
                         "--no-pictures",
                         "--no-details",
                         "--texel",
                         "0.05",
                         "--formats",
                         "svg"});
        maps.push_back(judge(map, session, kinds()[kind], name));
      }
    }
  std::cout << '\n';
  printHead("kinds | good | Good | Usable | Not usable | Undetermined | bad | Good | "
            "Usable | Not usable | Undetermined");
  for (const FaultKind& kind : kinds()) {
    static std::string name;
    name = kind.fault.name;
    addRow(
        name, maps, [](const JudgedMap& map) { return map.kind == name; }, false);
  }
  addRow(
      "tuned",
      maps,
      [](const JudgedMap& map) { return map.is_tuned && !map.is_undecidable; },
      true);
  addRow(
      "held out",
      maps,
      [](const JudgedMap& map) { return !map.is_tuned && !map.is_undecidable; },
      true);
  addRow(
      "both", maps, [](const JudgedMap& map) { return !map.is_undecidable; }, true);
}

const Section headings_section("headings", printHeadings);

} // namespace
} // namespace pcl::acmap::bench
