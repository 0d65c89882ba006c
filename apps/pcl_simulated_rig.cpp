#include "memory.h"
#include "output_target.h"
#include "simulated_rig/raw_session.h"
#include "simulated_rig/simulation_options.h"
#include "simulated_rig/truth_file.h"

#include <pcl/core/parallel.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/simulation/scene_file.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace {

using namespace pcl::acmap;
using Json = nlohmann::ordered_json;

/** \brief Results of --clouds, for summary and report. */
struct Counts {
  std::size_t observations = 0;
  PointCounts points;
  std::size_t sparse = 0; ///< observations with fewer points than requested
  std::string first_sparse;
};

pcl::SimulatedScene
openScene(const std::string& name)
{
  const auto& standard = pcl::standardSceneNames();
  if (std::find(standard.begin(), standard.end(), name) != standard.end())
    return pcl::standardScene(name);
  std::error_code error;
  if (!std::filesystem::exists(name, error))
    throw pcl::InputFileException(name + ": is no file, and no standard scene (" +
                                  listOfScenes() + ")");
  return pcl::loadSimulatedScene(name);
}

void
checkPlaces(const Tool& tool,
            const SimulationOptions& options,
            const OutputFolder& folder)
{
  requireNoSession(folder);
  const std::string own_truth = options.output + "/" + truth_name;
  tool.requireReportWritable(
      {options.scene, options.cameras, options.merged, own_truth});
  if (options.merged.empty())
    return;
  requireWritable(options.merged, {".pcd"}, {options.scene});
  if (folder.holds(options.merged) &&
      isSessionName(std::filesystem::path(options.merged).filename().string()))
    throw UsageError(options.merged + ": would be one of the session's own files");
}

void
requireMemoryForMerging(const pcl::SimulatedScene& scene, std::size_t views)
{
  // coordinates, colour, view, label, and the same for the copy as a cloud
  constexpr std::size_t bytes_per_point = 48;
  requireMemory(scene.mostPointsOfView() * views * bytes_per_point, "the merged cloud");
}

void
count(const pcl::SimulatedObservation& observation, Counts& counts)
{
  counts.points.all += observation.points;
  for (const pcl::ObservationPixel& pixel : observation.pixels)
    ++counts.points.of_label[pixel.label];
}

Counts
writeObservations(Tool& tool,
                  const SimulationOptions& options,
                  const pcl::SimulatedScene& scene,
                  const OutputFolder& folder,
                  pcl::MergedObservations& merged)
{
  Counts counts;
  counts.points.of_label.resize(scene.geometry.planes().size() + 1);
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
      if (!scene.depth_camera && observation.points < scene.sensor.pointsOfView(view) &&
          counts.sparse++ == 0)
        counts.first_sparse =
            observationName(view) + " with " + std::to_string(observation.points);
    }
  });
  counts.observations = views;
  return counts;
}

/** \brief Reports the sensor and its noise. */
void
addSensor(const pcl::SimulatedScene& scene, Json& json)
{
  const pcl::RangeSensor& sensor = scene.sensor;
  if (!scene.depth_camera) {
    json["reach"] = sensor.reach;
    json["noise"] = {{"along", "ray"},
                     {"growth", sensor.noise_growth},
                     {"least", sensor.min_noise},
                     {"most", sensor.max_noise}};
    return;
  }
  const pcl::DepthCamera& camera = *scene.depth_camera;
  json["sensor"] = kinect_sensor;
  json["reach"] = camera.farthest;
  json["noise"] = {{"along", "disparity"},
                   {"sigma", scene.rig.disparity_sigma},
                   {"step", camera.disparity_step},
                   {"window", camera.window}};
}

void
saveCloudTruth(const std::string& path,
               const SimulationOptions& options,
               const pcl::SimulatedScene& scene,
               const Counts& counts)
{
  Json json = truthHead(scene, options.seed, counts.observations);
  json["points"] = counts.points.all;
  addSensor(scene, json);
  json["planes"] = truthPlanes(scene, counts.points);
  saveTruth(path, json);
}

void
tellResults(Tool& tool, const SimulationOptions& options, const Counts& counts)
{
  if (counts.sparse > 0)
    tool.warn(std::to_string(counts.sparse) +
              " observations see too little to have all their points, first " +
              counts.first_sparse);
  tool.details() = {{"scene", options.scene},
                    {"output", options.output},
                    {"sensor", options.sensor},
                    {"seed", options.seed},
                    {"observations", counts.observations},
                    {"points", counts.points.all},
                    {"sparse_observations", counts.sparse}};
  tool.tell("observations", std::to_string(counts.observations));
  tool.tell("points", std::to_string(counts.points.all));
  tool.tell("folder", options.output);
  if (!options.merged.empty())
    tool.tell("merged", options.merged);
}

void
tellSession(Tool& tool,
            const SimulationOptions& options,
            const SessionSettings& settings,
            const SessionCounts& counts)
{
  const double lit = static_cast<double>(counts.lit) / static_cast<double>(counts.seen);
  tool.details() = {{"scene", options.scene},
                    {"output", options.output},
                    {"seed", options.seed},
                    {"observations", settings.observations},
                    {"patterns", settings.patterns},
                    {"frames", counts.frames},
                    {"lit_share", lit}};
  if (!options.cameras.empty())
    tool.details()["cameras"] = options.cameras;
  tool.tell("observations", std::to_string(settings.observations));
  tool.tell("frames", std::to_string(counts.frames));
  tool.tell("folder", options.output);
}

void
makeClouds(Tool& tool,
           const SimulationOptions& options,
           const pcl::SimulatedScene& scene,
           pcl::Trajectory trajectory,
           StepTimer& timer)
{
  pcl::MergedObservations merged;
  merged.trajectory = std::move(trajectory);
  if (!options.merged.empty())
    requireMemoryForMerging(scene, merged.trajectory.poses.size());
  OutputFolder folder(options.output);
  checkPlaces(tool, options, folder);
  timer.finish("read");

  const Counts counts = writeObservations(tool, options, scene, folder, merged);
  if (counts.points.all == 0)
    throw NothingFound(options.scene + ": no view sees anything in reach");
  timer.finish("observe");

  pcl::saveTrajectory(folder.path(trajectory_name), merged.trajectory);
  pcl::saveTrinocularRig(folder.path(rig_name), scene.rig);
  saveCloudTruth(folder.path(truth_name), options, scene, counts);
  tool.stopIfInterrupted();
  if (!options.merged.empty())
    pcl::savePointCloud(options.merged, pcl::cloudOf(merged));
  folder.commit();
  timer.finish("write");
  tellResults(tool, options, counts);
}

void
makeSession(Tool& tool,
            const SimulationOptions& options,
            FilmedScene filmed,
            std::size_t views,
            StepTimer& timer)
{
  if (!options.cameras.empty())
    for (const std::string& remark : setBuiltCameras(options.cameras, filmed))
      tool.warn(options.cameras + ": " + remark);
  const SessionSettings settings{
      views, options.patterns, options.light, options.seed, tool.threads()};
  OutputFolder folder(options.output);
  checkPlaces(tool, options, folder);
  timer.finish("read");

  SessionCounts counts;
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    counts = writeSession(folder, filmed, settings, progress);
  });
  if (counts.seen == 0)
    throw NothingFound(options.scene + ": no view sees anything");
  tool.stopIfInterrupted();
  folder.commit();
  timer.finish("film");
  tellSession(tool, options, settings, counts);
}

void
simulate(Tool& tool, const SimulationOptions& options)
{
  requireSense(tool, options);
  StepTimer timer(tool.report());
  pcl::SimulatedScene scene = openScene(options.scene);
  if (options.sensor == kinect_sensor)
    pcl::useKinect(scene);
  pcl::Trajectory trajectory = pcl::trajectoryOf(
      scene, options.observations ? options.observations : scene.views.size());
  if (options.clouds)
    makeClouds(tool, options, scene, std::move(trajectory), timer);
  else
    makeSession(
        tool, options, {std::move(scene), {}, {}}, trajectory.poses.size(), timer);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_simulated_rig",
            "Simulates what the rig measures on its way through a building.");
  SimulationOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { simulate(tool, options); });
}
