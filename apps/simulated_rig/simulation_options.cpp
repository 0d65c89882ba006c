#include "simulation_options.h"

#include <pcl/simulation/standard_scenes.h>

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

void
addLightOptions(CLI::App& app, SimulatedLight& light)
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
         options.patterns,
         "Shots of an observation under a pattern of lines each, beside the one "
         "without")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{1}, max_patterns).description(""));
  app.add_option("--cameras",
                 options.cameras,
                 "Cameras as they are built, with distortion and out of line, in place "
                 "of the scene's rectified rig; frames are then raw, the truth is that "
                 "of the rectified ones")
      ->type_name("RIG.yaml")
      ->default_str("");
  addLightOptions(app, options.light);
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
  app.add_option("--merged",
                 options.merged,
                 "With --clouds, write all points as one cloud too: x y z rgb view "
                 "label, map frame")
      ->type_name("MAP.pcd");
}

} // namespace

std::string
listOfScenes()
{
  std::string list;
  for (const std::string& name : standardSceneNames())
    list += (list.empty() ? "" : ", ") + name;
  return list;
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
                 options.observations,
                 "Only the first N views of the scene [default: all]")
      ->type_name("N")
      ->default_str("")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  addFrameOptions(app, options);
  addCloudOptions(app, options);
  tool.addSeed(options.seed);
  tool.addThreads();
}

void
requireSense(Tool& tool, const SimulationOptions& options)
{
  for (const char* const name : {"--output", "--scene", "--cameras", "--merged"}) {
    const CLI::Option& option = *tool.options().get_option(name);
    if (option.count() > 0 && option.as<std::string>().empty())
      throw UsageError(std::string(name) + " names nothing");
  }
  if (!options.clouds)
    for (const char* const name : {"--merged", "--sensor"})
      if (tool.options().count(name) > 0)
        throw UsageError(std::string(name) + " needs --clouds");
  if (options.clouds)
    for (const char* const name : {"--patterns",
                                   "--cameras",
                                   "--ambient",
                                   "--projector-power",
                                   "--exposure",
                                   "--read-noise",
                                   "--shot-noise",
                                   "--blur",
                                   "--vignetting"})
      if (tool.options().count(name) > 0)
        throw UsageError(std::string(name) +
                         " is for camera frames, --clouds makes none");
  requireSoundLight(options.light);
}

} // namespace pcl::acmap
