#include "chain_report.h"

#include "compact_mapping/map_stage.h"

#include <pcl/pipeline/map_report.h>

#include <CLI/StringTools.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

namespace pcl::acmap {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char *plan_name = "floor_plan.png", *mesh_name = "mesh.png";

constexpr std::pair<const char*, const char*> captions[] = {
    {"inside.png", "The map from inside, textured."},
    {"outside.png", "The map from outside, without the faces that look away."},
    {plan_name, "Floor plan: walls, doors, windows, rooms and their dimensions."},
    {"planes.png", "The mesh, in colours by plane."},
    {mesh_name, "The mesh of the consolidated points."},
    {"plan.png",
     "The consolidated points from above, before and after rectification."}};

/** \param[in] tilt of the map's frame, degrees
 * \param[in] is_raw Was the mesh made of raw points? */
Json
picturesIn(const std::string& folder, double tilt, bool is_raw)
{
  Json pictures = Json::array();
  std::error_code error;
  for (const auto& [name, caption] : captions)
    if (fs::exists(fs::path(folder) / pictureName(name), error)) {
      std::string text = is_raw && std::string_view(name) == mesh_name
                             ? "The mesh of the raw points."
                             : caption;
      if (tilt > min_tilt_told && std::string_view(name) == plan_name)
        text +=
            " Drawn along the floor, from which the frame of the map is tilted by " +
            shortNumber(tilt) + " degrees.";
      pictures.push_back({{"file", pictureName(name)}, {"caption", text}});
    }
  return pictures;
}

/** \brief The line that is told first: the given poses are kept, for want of a proof. */
constexpr std::string_view undetermined = "undetermined";

/** \brief Lines of the stages that are told without --verbose, too: what was found out or assumed of
 * the input, and what became of the poses. */
constexpr std::string_view always_told[] = {
    "read",        "columns",      "coordinates", "layout",     "intrinsics",
    "depth scale", "median depth", "left out",    "matched",    "up",
    "sensor",      "noise",        "posed",       "joined",     "rectified",
    "kept",        "refused",      "verdict",     "error left", "moved by planes",
    "recorded",    "finished",     "ranks",       "tilted"};

/** \brief Is a line of a step's summary told? The folders belong to the chain, and there is one
 * line for the seconds of all steps. */
bool
isForChain(const std::string& line, bool verbose)
{
  const auto is = [&](std::string_view name) { return line == name; };
  return line != "seconds" && line != "folder" &&
         (verbose || std::any_of(std::begin(always_told), std::end(always_told), is));
}

/** \brief Tells the lines of a stage: with --verbose all of them, under its name. */
void
tellLines(const RunStage& stage, bool verbose, StageLog& log)
{
  const std::string indent = verbose ? "  " : "";
  if (verbose)
    log.tell(stage.name,
             stage.is_reused ? "as it was finished before"
                             : shortNumber(totalSeconds(stage.told)) + " s");
  for (const auto& line : stage.told.lines) {
    const bool is_told =
        !verbose && std::count(log.lines.begin(), log.lines.end(), line) > 0;
    if (line.first == undetermined)
      log.lines.insert(log.lines.begin(), line);
    else if (isForChain(line.first, verbose) && !is_told)
      log.tell(indent + line.first, line.second);
  }
  if (!stage.removed.empty())
    log.tell(indent + "removed",
             CLI::detail::join(stage.removed, ", ") + " of the result before");
}

void
tellStage(const RunStage& stage, bool verbose, StageLog& log)
{
  const StageLog& told = stage.told;
  tellLines(stage, verbose, log);
  log.warn(told.report.remarks);
  if (log.contradiction.empty())
    log.contradiction = told.contradiction;
  if (!stage.is_reused)
    log.report.seconds.emplace_back(stage.name, totalSeconds(told));
}

Json
jsonOf(const RunStage& stage)
{
  Json json = {{"name", stage.name}, {"reused", stage.is_reused}};
  json.update(acmap::jsonOf(stage.told));
  if (!stage.removed.empty())
    json["removed"] = stage.removed;
  return json;
}

} // namespace

void
tellChain(const ChainOptions& options,
          StartingPoint start,
          const std::vector<RunStage>& stages,
          const std::optional<MapFigures>& figures,
          StageLog& log)
{
  Json& details = log.details;
  details["input"] = options.input;
  details["output"] = options.output;
  details["starting_point"] = nameOf(start);
  details["mode"] = options.planes.paper ? "paper" : "accurate";
  const Json& map = stages.back().told.details;
  for (const char* name : {"quality",
                           "next_positions",
                           "observations",
                           "finite_points",
                           "bytes",
                           "texture"})
    if (map.contains(name))
      details[name] = map.at(name);
  details["planes"] = map.at("planes").size();
  for (const char* name : {"cylinders", "boxes", "recesses"})
    if (map.contains(name))
      details[name] = map.at(name).size();
  details["stages"] = Json::array();
  for (const RunStage& stage : stages) {
    tellStage(stage, options.verbose, log);
    details["stages"].push_back(jsonOf(stage));
  }
  if (figures) {
    details["truth"] = Json::parse(truthDetailsText(*figures));
    for (const auto& [name, value] : truthSummary(*figures))
      log.tell(name, value);
  }
  details["pictures"] =
      picturesIn(options.output, map.value("tilt_deg", 0.0), options.planes.paper);
  for (const auto& [name, value] : MapReport(jsonText(details)).summary())
    log.tell(name, value);
  for (const auto& [name, value] : stages.back().told.lines)
    if (name == "compactness")
      log.tell(name, value);
  log.tellSeconds();
  if (options.verbose)
    log.tell("folder", options.output);
  if (!log.contradiction.empty())
    return;
  std::error_code error;
  for (const char* page : {"map.html", "report.html"})
    if (const fs::path path = fs::path(options.output) / page;
        std::string_view(page) == "report.html" || fs::exists(path, error))
      log.tell("open", path.string());
}

} // namespace pcl::acmap
