#include "output_target.h"
#include "setter_option.h"
#include "simulated_rig/session.h"
#include "tool.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/core/point_cloud_writer.h>
#include <pcl/core/process_memory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_writing.h>
#include <pcl/simulation/merged_rows.h>
#include <pcl/simulation/repeated_scene.h>
#include <pcl/simulation/simulated_light.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/standard_scenes.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <regex>
#include <string>

namespace {

using namespace pcl::acmap;
constexpr const char* stereo_sensor = "stereo";
constexpr const char* kinect_sensor = "kinect";

struct SimulationOptions {
  std::string output;
  std::string scene = "corridor";
  std::string cameras;      ///< path; empty for those of the scene's rig
  SessionSettings settings; ///< 0 observations for all, until the scene is open
  bool clouds = false;
  std::string sensor = stereo_sensor; ///< sensor that measures the clouds
  bool all_points = false;            ///< instead of the scene's number
  std::size_t columns = 1, rows = 1;  ///< copies of the scene in the building
  std::string merged;
};

/** \brief Results of --clouds, for summary and report. */
struct Counts {
  pcl::TruthPoints points;
  std::size_t observations = 0;
  std::size_t sparse = 0; ///< observations with fewer points than requested
  std::string first_sparse = {};
};

void
addLightOptions(CLI::App& app, pcl::SimulatedLight& light)
{
  app.add_option("--ambient",
                 light.ambient,
                 "Light of the room: share of a surface's colour that is seen with the "
                 "projector off")
      ->type_name("SHARE");
  app.add_option("--projector-power",
                 light.projector.power,
                 "The projector's light on a surface 2 m before it, in the unit of "
                 "--ambient")
      ->type_name("SHARE");
  app.add_option("--aperture",
                 light.projector.aperture_radius,
                 "Radius of what the projector lights, around the middle of its "
                 "pattern, pixels of the pattern")
      ->type_name("PX");
  app.add_option("--exposure", light.exposure, "Factor on all light")
      ->type_name("FACTOR");
  app.add_option("--read-noise",
                 light.read_noise,
                 "Noise in the dark, grey levels, one standard deviation")
      ->type_name("LEVELS");
  app.add_option("--shot-noise",
                 light.shot_noise,
                 "Noise of the light: variance that a grey level adds, grey levels")
      ->type_name("LEVELS");
  app.add_option(
         "--blur", light.blur, "Blur of the cameras, pixels, one standard deviation")
      ->type_name("PX");
  app.add_flag("--vignetting",
               light.vignetting,
               "Let light fall off towards the rim of the images");
}

void
addFrameOptions(CLI::App& app, SimulationOptions& options)
{
  constexpr std::uint32_t max_patterns = 100;
  app.add_option(
         "--patterns",
         options.settings.patterns,
         "Shots of an observation under a pattern of lines each, beside the one "
         "without")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{1}, max_patterns).description(""));
  addSetter(app,
            "--lines",
            options.settings.lines,
            &pcl::RandomLinePattern::setNumberOfLines,
            &pcl::RandomLinePattern::getNumberOfLines,
            "Lines of a pattern",
            "N");
  app.add_option("--cameras",
                 options.cameras,
                 "Cameras as they are built, with distortion and out of line, in place "
                 "of the scene's rectified rig; frames are then raw, the truth is that "
                 "of the rectified ones")
      ->type_name("RIG.yaml")
      ->default_str("");
  addLightOptions(app, options.settings.light);
}

void
addCloudOptions(CLI::App& app, SimulationOptions& options)
{
  app.add_flag("--clouds",
               options.clouds,
               "Write organized point clouds with truth (metres, camera frame) instead "
               "of a raw session of camera frames");
  app.add_option(
         "--sensor",
         options.sensor,
         "With --clouds, what measures: the stereo of the scene's rig, or a depth "
         "camera as the first Kinect, with its quantised depths, shadows and rims")
      ->type_name("stereo|kinect")
      ->check(CLI::IsMember({stereo_sensor, kinect_sensor}).description(""));
  app.add_flag(
      "--all-points",
      options.all_points,
      "With --clouds, every pixel that sees a surface in reach becomes a point, "
      "however many points the scene asks for");
  app.add_option_function<std::string>(
         "--repeat",
         [&options](const std::string& text) {
           const std::size_t by = text.find('x');
           options.columns = std::stoul(text.substr(0, by));
           options.rows = std::stoul(text.substr(by + 1));
         },
         "With --clouds, a building of N by M copies of the scene, each with noise "
         "of its own")
      ->type_name("NxM")
      ->default_str("")
      ->check(CLI::Validator(
          [](std::string& text) {
            return std::regex_match(text, std::regex("[1-9][0-9]{0,2}x[1-9][0-9]{0,2}"))
                       ? std::string()
                       : "'" + text + "' is no number of columns and rows, such as 3x2";
          },
          ""));
  app.add_option("--merged",
                 options.merged,
                 "With --clouds, write all points as one cloud too: x y z rgb view "
                 "label, map frame")
      ->type_name("MAP.pcd");
}

void
addOptions(Tool& tool, SimulationOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("-o,--output", options.output, "Folder for the session")
      ->type_name("SESSION_DIR")
      ->required();
  app.add_option("--scene", options.scene, "A scene file, or " + listOfScenes())
      ->type_name("S.yaml|NAME");
  app.add_option("--observations",
                 options.settings.observations,
                 "Only the first N views of the scene [default: all]")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  addFrameOptions(app, options);
  addCloudOptions(app, options);
  tool.addSeed(options.settings.seed,
               [&](std::uint64_t seed) { options.settings.seed = seed; });
  tool.addThreads();
}

/** Refuses options that exclude each other, and illegal light settings. */
void
requireSense(Tool& tool, const SimulationOptions& options)
{
  for (const char* const name : {"--output", "--scene", "--cameras", "--merged"}) {
    const CLI::Option& option = *tool.options().get_option(name);
    if (option.count() > 0 && option.as<std::string>().empty())
      throw UsageError(std::string(name) + " names nothing");
  }
  if (!options.clouds)
    for (const char* const name : {"--merged", "--sensor", "--all-points", "--repeat"})
      if (tool.options().count(name) > 0)
        throw UsageError(std::string(name) + " needs --clouds");
  if (options.clouds)
    for (const char* const name : {"--patterns",
                                   "--lines",
                                   "--cameras",
                                   "--ambient",
                                   "--projector-power",
                                   "--aperture",
                                   "--exposure",
                                   "--read-noise",
                                   "--shot-noise",
                                   "--blur",
                                   "--vignetting"})
      if (tool.options().count(name) > 0)
        throw UsageError(std::string(name) +
                         " is for camera frames, --clouds makes none");
  if (options.all_points && options.sensor == kinect_sensor)
    throw UsageError("--all-points is for stereo, a kinect has no number of points");
  pcl::requireSoundLight(options.settings.light);
}

/** Opens the scene with its cameras, and counts its observations. */
FilmedScene
openScene(SimulationOptions& options, StageLog& log)
{
  FilmedScene filmed;
  filmed.scene = pcl::openSimulatedScene(options.scene);
  if (options.sensor == kinect_sensor)
    pcl::useKinect(filmed.scene);
  pcl::RangeSensor& sensor = filmed.scene.sensor;
  if (options.all_points) {
    sensor.points = static_cast<std::size_t>(filmed.scene.rig.width) *
                    static_cast<std::size_t>(filmed.scene.rig.height);
    sensor.views_with_one_more = 0;
  }
  std::size_t& views = options.settings.observations;
  views = pcl::trajectoryOf(filmed.scene, views ? views : filmed.scene.views.size())
              .poses.size();
  if (!options.cameras.empty())
    for (const std::string& remark : setBuiltCameras(options.cameras, filmed))
      log.warn(options.cameras + ": " + remark);
  return filmed;
}

void
checkPlaces(const Tool& tool,
            const SimulationOptions& options,
            const OutputFolder& folder)
{
  requireNoneIn(folder, isSessionName);
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

/** \param[in] scene without its copies
 * \param[in] trajectory of all views of all copies */
Counts
writeClouds(const SimulationOptions& options,
            const pcl::SimulatedScene& scene,
            const pcl::Trajectory& trajectory,
            const OutputFolder& folder,
            const RunControls& controls,
            pcl::MergedRows& merged)
{
  Counts counts{pcl::TruthPoints(options.columns * options.rows *
                                 scene.geometry.planes().size())};
  counts.observations = trajectory.poses.size();
  const auto observe = [&](std::size_t view) -> std::optional<ObservationToWrite> {
    const pcl::SimulatedObservation observation = withThreads(controls.threads, [&] {
      return pcl::observeRepeated(scene, view, options.settings.seed);
    });
    if (!options.merged.empty())
      merged.append(observation, view);
    counts.points.all += observation.points;
    for (const pcl::ObservationPixel& pixel : observation.pixels)
      ++counts.points.of_label[pixel.label];
    if (!scene.depth_camera && !options.all_points &&
        observation.points < scene.sensor.pointsOfView(view % scene.views.size()) &&
        counts.sparse++ == 0)
      counts.first_sparse =
          observationName(view) + " with " + std::to_string(observation.points);
    return {{std::make_shared<pcl::PCLPointCloud2>(pcl::cloudOf(observation)),
             trajectory.poses[view]}};
  };
  writeObservations(
      folder, counts.observations, observe, {controls.progress, "observing"});
  return counts;
}

void
makeClouds(const SimulationOptions& options,
           const pcl::SimulatedScene& scene,
           OutputFolder& folder,
           const RunControls& controls,
           StageLog& log)
{
  StepTimer timer(log.report);
  const pcl::ScratchMemory scratch(folder.path(""), residentScratch());
  pcl::SimulatedScene filmed = scene; // as far as it is filmed
  filmed.views.resize(options.settings.observations);
  const pcl::SimulatedScene building =
      pcl::repeatedScene(filmed, options.columns, options.rows);
  const pcl::Trajectory trajectory = pcl::trajectoryOf(building, building.views.size());
  pcl::MergedRows merged(trajectory);
  const Counts counts =
      writeClouds(options, filmed, trajectory, folder, controls, merged);
  if (counts.points.all == 0)
    throw NothingFound(options.scene + ": no view sees anything in reach");
  timer.finish("observe");

  pcl::saveTrajectory(folder.path(trajectory_name), trajectory);
  pcl::saveTrinocularRig(folder.path(rig_name), scene.rig);
  pcl::saveCloudTruth(folder.path(truth_name),
                      scene,
                      building,
                      options.settings.seed,
                      counts.observations,
                      counts.points);
  stopIfInterrupted();
  if (!options.merged.empty())
    pcl::savePointCloud(options.merged, merged.finish());
  folder.commit();
  timer.finish("write");

  if (counts.sparse > 0)
    log.warn(std::to_string(counts.sparse) +
             " observations see too little to have all their points, first " +
             counts.first_sparse);
  log.details = {{"scene", options.scene},
                 {"output", options.output},
                 {"sensor", options.sensor},
                 {"seed", options.settings.seed},
                 {"observations", counts.observations},
                 {"points", counts.points.all},
                 {"sparse_observations", counts.sparse}};
  log.tell("observations", std::to_string(counts.observations));
  log.tell("points", std::to_string(counts.points.all));
  log.tell("folder", options.output);
  if (!options.merged.empty())
    log.tell("merged", options.merged);
}

void
makeSession(const SimulationOptions& options,
            const FilmedScene& filmed,
            OutputFolder& folder,
            const RunControls& controls,
            StageLog& log)
{
  StepTimer timer(log.report);
  const SessionSettings& settings = options.settings;
  const SessionCounts counts = writeSession(folder, filmed, settings, controls);
  if (counts.seen == 0)
    throw NothingFound(options.scene + ": no view sees anything");
  stopIfInterrupted();
  folder.commit();
  timer.finish("film");

  const double lit = static_cast<double>(counts.lit) / static_cast<double>(counts.seen);
  log.details = {{"scene", options.scene},
                 {"output", options.output},
                 {"seed", settings.seed},
                 {"observations", settings.observations},
                 {"patterns", settings.patterns},
                 {"lines", settings.lines.getNumberOfLines()},
                 {"frames", counts.frames},
                 {"lit_share", lit}};
  if (!options.cameras.empty())
    log.details["cameras"] = options.cameras;
  log.tell("observations", std::to_string(settings.observations));
  log.tell("frames", std::to_string(counts.frames));
  log.tell("folder", options.output);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_simulated_rig",
            "Simulates what the rig measures on its way through a building.");
  SimulationOptions options;
  addOptions(tool, options);
  tool.setHelp(
      {{{"pcl_simulated_rig -o session", "Films a simulated corridor as a rig would."},
        {"pcl_simulated_rig -o clouds --scene office --clouds",
         "Point clouds of an office with their true poses."}},
       {}});
  return tool.run(argc, argv, [&] {
    requireSense(tool, options);
    StageLog& log = tool.log();
    StepTimer timer(log.report);
    const FilmedScene filmed = openScene(options, log);
    OutputFolder folder(options.output);
    checkPlaces(tool, options, folder);
    timer.finish("read");
    if (options.clouds)
      makeClouds(options, filmed.scene, folder, tool.controls(), log);
    else
      makeSession(options, filmed, folder, tool.controls(), log);
  });
}
