#include "import_options.h"

#include "command_line.h"

#include <CLI/CLI.hpp>

namespace pcl::acmap {

namespace {

/** \brief Adds an option for a finite number above zero, in a range for which points
 * are finite. */
template <typename Value>
CLI::Option*
addPositive(CLI::App& app,
            const std::string& name,
            Value& value,
            const std::string& type,
            const std::string& purpose)
{
  return app.add_option(name, value, purpose)
      ->type_name(type)
      ->check(positiveNumber().description(""))
      ->check(CLI::Range(1e-6, 1e6).description(""));
}

void
addCamera(CLI::App& app, ImportOptions& options)
{
  app.add_option("--intrinsics",
                 options.intrinsics,
                 "The depth camera: a text file with its 3 x 3 matrix, or a rig.yaml "
                 "[default: the folder's, or its layout's]")
      ->type_name("FILE");
  auto* const fx = addPositive(app,
                               "--fx",
                               options.fx,
                               "PX",
                               "Focal length across in pixels, instead of the above");
  addPositive(app, "--fy", options.fy, "PX", "Focal length down [default: --fx]")
      ->needs(fx);
  addPositive(app, "--cx", options.cx, "PX", "Column of the principal point");
  addPositive(app, "--cy", options.cy, "PX", "Row of the principal point");
  addPositive(app,
              "--depth-scale",
              options.depth_scale,
              "N",
              "Numbers of a depth image in a metre [default: 5000 for TUM, 1000 for "
              "7-Scenes]");
  addPositive(app,
              "--max-depth",
              options.max_depth,
              "M",
              "Leave out points farther than this, metres [default: none]")
      ->default_str("");
}

void
addColorCamera(CLI::App& app, ImportOptions& options)
{
  auto* const file =
      app.add_option("--color-camera",
                     options.color_camera,
                     "The camera that saw the colours, where that is another one: YAML "
                     "with its pinhole and its pose [default: 7-Scenes' for 7-Scenes' "
                     "Kinect, else none]");
  file->type_name("FILE");
  app.add_flag("--registered",
               options.is_registered,
               "Colour and depth images show the same, pixel by pixel, as TUM's do")
      ->excludes(file);
}

} // namespace

void
addOptions(Tool& tool, ImportOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("input",
                 options.input,
                 "RGB-D folder: rgb.txt, depth.txt, groundtruth.txt as of TUM, or "
                 "frame-000000.color.jpg, .depth.png, .pose.txt as of 7-Scenes")
      ->type_name("DIR")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the observations")
      ->type_name("OBS_DIR")
      ->required();
  app.add_flag("--no-poses", options.no_poses, "Leave poses out, known or not");
  app.add_flag("--skip-broken",
               options.skip_broken,
               "Leave out frames with a missing or damaged file instead of giving up");
  addCamera(app, options);
  addColorCamera(app, options);
  addSensor(tool, options.sensor);
  app.add_option("--every", options.every, "Take only each Nth frame")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  addPositive(app,
              "--max-stamp-gap",
              options.max_stamp_gap,
              "S",
              "Seconds between what TUM's lists have of one moment, at most");
}

RgbdSequenceSettings
settingsOf(const ImportOptions& options)
{
  RgbdSequenceSettings settings;
  settings.has_poses = !options.no_poses;
  settings.max_stamp_gap = options.max_stamp_gap;
  settings.has_camera =
      !options.intrinsics.empty() || (options.fx && options.cx && options.cy);
  return settings;
}

Pinhole
cameraOf(const ImportOptions& options, const RgbdSequence& sequence)
{
  Pinhole camera =
      options.intrinsics.empty() ? sequence.camera : loadPinhole(options.intrinsics);
  if (options.fx)
    camera.fx = camera.fy = *options.fx;
  if (options.fy)
    camera.fy = *options.fy;
  camera.cx = options.cx.value_or(camera.cx);
  camera.cy = options.cy.value_or(camera.cy);
  return camera;
}

std::optional<ColorCamera>
colorCameraOf(const ImportOptions& options, const RgbdSequence& sequence)
{
  if (options.is_registered)
    return {};
  if (!options.color_camera.empty())
    return loadColorCamera(options.color_camera);
  return sequence.color_camera;
}

} // namespace pcl::acmap
