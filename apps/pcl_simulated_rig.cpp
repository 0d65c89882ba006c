#include "memory.h"
#include "observation_folder.h"
#include "output_target.h"
#include "tool.h"

#include <pcl/core/build_config.h>
#include <pcl/core/output_file.h>
#include <pcl/core/parallel.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/simulation/scene_file.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace {

using namespace pcl::acmap;
using Json = nlohmann::ordered_json;

constexpr const char* rig_name = "rig.yaml";
constexpr const char* truth_name = "truth.json";

struct Options {
  std::string output;
  std::string scene = "corridor";
  std::size_t observations = 0;
  std::uint64_t seed = 1;
  bool clouds = false;
  std::string merged;
};

/** \brief What was done, for summary and report. */
struct Counts {
  std::size_t observations = 0;
  std::size_t points = 0;
  std::size_t sparse = 0; ///< observations with fewer points than asked for
  std::string first_sparse;
  std::vector<std::size_t> points_of_label;
};

std::string
listOfScenes(const char* separator)
{
  std::string list;
  for (const std::string& name : pcl::standardSceneNames())
    list += (list.empty() ? "" : separator) + name;
  return list;
}

void
addOptions(Tool& tool, Options& options)
{
  CLI::App& app = tool.options();
  app.add_option("-o,--output", options.output, "Folder for the session")
      ->type_name("SESSION_DIR")
      ->required();
  app.add_option("--scene", options.scene, "A scene file, or " + listOfScenes(", "))
      ->type_name("S.yaml|NAME");
  app.add_option("--observations",
                 options.observations,
                 "Only the first N views of the scene [default: all]")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  app.add_flag("--clouds",
               options.clouds,
               "Write organized point clouds with truth (metres, camera frame); needed "
               "so far, as camera frames are not made yet");
  app.add_option("--merged",
                 options.merged,
                 "Write all points as one cloud too: x y z rgb view label, map frame")
      ->type_name("MAP.pcd");
  app.add_option("--seed", options.seed, "Number that all randomness begins with")
      ->type_name("N")
      ->check(CLI::Validator(CLI::NonNegativeNumber).description(""));
  tool.addThreads();
}

pcl::SimulatedScene
openScene(const std::string& name)
{
  const auto& standard = pcl::standardSceneNames();
  if (std::find(standard.begin(), standard.end(), name) != standard.end())
    return pcl::standardScene(name);
  std::error_code error;
  if (!std::filesystem::exists(name, error))
    throw pcl::InputFileException(name + ": is no file, and no standard scene (" +
                                  listOfScenes(", ") + ")");
  return pcl::loadSimulatedScene(name);
}

bool
isSessionName(const std::string& name)
{
  return isSequenceName(name) || name == rig_name || name == truth_name;
}

void
checkPlaces(const Tool& tool, const Options& options, const OutputFolder& folder)
{
  requireNoSequence(folder, {rig_name, truth_name});
  std::vector<std::string> others = {options.scene};
  const std::string own_truth = options.output + "/" + truth_name;
  tool.requireReportWritable({options.scene, options.merged, own_truth});
  if (options.merged.empty())
    return;
  requireWritable(options.merged, {".pcd"}, others);
  if (folder.holds(options.merged) &&
      isSessionName(std::filesystem::path(options.merged).filename().string()))
    throw UsageError(options.merged + ": would be one of the session's own files");
}

void
requireMemoryForMerging(const pcl::SimulatedScene& scene, std::size_t views)
{
  // coordinates, colour, view, label, and the same again as a cloud
  constexpr std::size_t bytes_per_point = 48;
  requireMemory(scene.sensor.points * views * bytes_per_point, "the merged cloud");
}

void
count(const pcl::SimulatedObservation& observation, Counts& counts)
{
  counts.points += observation.points;
  for (const pcl::ObservationPixel& pixel : observation.pixels)
    ++counts.points_of_label[pixel.label];
}

Counts
writeObservations(Tool& tool,
                  const Options& options,
                  const pcl::SimulatedScene& scene,
                  const OutputFolder& folder,
                  pcl::MergedObservations& merged)
{
  Counts counts;
  counts.points_of_label.resize(scene.geometry.planes().size() + 1);
  const std::size_t views = merged.trajectory.poses.size();
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const Progress told(progress);
    for (std::size_t view = 0; view < views; ++view) {
      told.tell(static_cast<double>(view) / static_cast<double>(views), "observing");
      const pcl::SimulatedObservation observation = withThreads(
          tool.threads(), [&] { return pcl::observe(scene, view, options.seed); });
      saveObservation(folder.path(observationName(view)),
                      pcl::cloudOf(observation),
                      merged.trajectory.poses[view]);
      if (!options.merged.empty())
        pcl::appendObservation(observation, view, merged);
      count(observation, counts);
      if (observation.points < scene.sensor.pointsOfView(view) && counts.sparse++ == 0)
        counts.first_sparse =
            observationName(view) + " with " + std::to_string(observation.points);
    }
  });
  counts.observations = views;
  return counts;
}

Json
jsonOf(const Eigen::Vector3d& point)
{
  return {point.x(), point.y(), point.z()};
}

Json
jsonOf(const pcl::TruthPlane& plane, std::size_t id, const Counts& counts)
{
  Json rectangles = Json::array();
  for (const pcl::SimulatedRectangle& r : plane.rectangles)
    rectangles.push_back({jsonOf(r.corner),
                          jsonOf(r.corner + r.edge_u),
                          jsonOf(r.corner + r.edge_u + r.edge_v),
                          jsonOf(r.corner + r.edge_v)});
  const Eigen::Vector4d& c = plane.coefficients;
  return {{"id", id},
          {"name", plane.name},
          {"coefficients", {c[0], c[1], c[2], c[3]}},
          {"area", plane.area()},
          {"points", counts.points_of_label[id + 1]},
          {"rectangles", rectangles}};
}

void
saveTruth(const std::string& path,
          const Options& options,
          const pcl::SimulatedScene& scene,
          const Counts& counts)
{
  const pcl::RangeSensor& sensor = scene.sensor;
  Json json = {{"version", ACMAP_VERSION},
               {"scene", scene.name},
               {"seed", options.seed},
               {"observations", counts.observations},
               {"points", counts.points},
               {"reach", sensor.reach},
               {"noise",
                {{"along", "ray"},
                 {"growth", sensor.noise_growth},
                 {"least", sensor.least_noise},
                 {"most", sensor.most_noise}}}};
  json["planes"] = Json::array();
  const std::vector<pcl::TruthPlane> planes = pcl::planesInMap(scene);
  for (std::size_t id = 0; id < planes.size(); ++id)
    json["planes"].push_back(jsonOf(planes[id], id, counts));
  const std::string text =
      json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

void
tellResults(Tool& tool, const Options& options, const Counts& counts)
{
  if (counts.sparse > 0)
    tool.warn(std::to_string(counts.sparse) +
              " observations see too little to have all their points, first " +
              counts.first_sparse);
  tool.details() = {{"scene", options.scene},
                    {"output", options.output},
                    {"seed", options.seed},
                    {"observations", counts.observations},
                    {"points", counts.points},
                    {"sparse_observations", counts.sparse}};
  tool.tell("observations", std::to_string(counts.observations));
  tool.tell("points", std::to_string(counts.points));
  tool.tell("folder", options.output);
  if (!options.merged.empty())
    tool.tell("merged", options.merged);
}

void
simulate(Tool& tool, const Options& options)
{
  if (!options.clouds)
    throw UsageError("camera frames are not made yet: add --clouds for point clouds");
  StepTimer timer(tool.report());
  const pcl::SimulatedScene scene = openScene(options.scene);
  pcl::MergedObservations merged;
  merged.trajectory = pcl::trajectoryOf(
      scene, options.observations ? options.observations : scene.views.size());
  if (!options.merged.empty())
    requireMemoryForMerging(scene, merged.trajectory.poses.size());
  OutputFolder folder(options.output);
  checkPlaces(tool, options, folder);
  timer.finish("read");

  const Counts counts = writeObservations(tool, options, scene, folder, merged);
  if (counts.points == 0)
    throw NothingFound(options.scene + ": no view sees anything in reach");
  timer.finish("observe");

  pcl::saveTrajectory(folder.path(trajectory_name), merged.trajectory);
  pcl::saveTrinocularRig(folder.path(rig_name), scene.rig);
  saveTruth(folder.path(truth_name), options, scene, counts);
  tool.stopIfInterrupted();
  if (!options.merged.empty())
    pcl::savePointCloud(options.merged, pcl::cloudOf(merged));
  folder.commit();
  timer.finish("write");
  tellResults(tool, options, counts);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_simulated_rig",
            "Simulates what the rig measures on its way through a building.");
  Options options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { simulate(tool, options); });
}
