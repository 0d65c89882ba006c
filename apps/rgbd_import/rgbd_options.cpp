#include "rgbd_options.h"

#include "command_line.h"

#include <pcl/core/calibration_file.h>

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
      ->check(numberWithin(1e-6, 1e6).description(""));
}

} // namespace

void
addRgbdCameras(CLI::App& app, RgbdOptions& options)
{
  app.add_option("--intrinsics",
                 options.intrinsics,
                 "The depth camera: a matrix as text, a rig.yaml, or a calibration by "
                 "Open3D, ROS, OpenCV, Kalibr, ORB-SLAM and others "
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
  addPositive(
      app,
      "--depth-scale",
      options.depth_scale,
      "N",
      "Numbers of a depth image in a metre [default: 5000 for TUM and ORB-SLAM, "
      "that of cam_params.json for Replica, else 1000]");
  auto* const file =
      app.add_option("--color-camera",
                     options.color_camera,
                     "The camera that saw the colours, where that is another one: YAML "
                     "with its pinhole and its pose [default: 7-Scenes' for 7-Scenes' "
                     "Kinect, ScanNet's of the folder, else none]");
  file->type_name("FILE");
  app.add_flag("--registered",
               options.is_registered,
               "Colour and depth images show the same, pixel by pixel, as TUM's do")
      ->excludes(file);
}

void
addNoPoses(CLI::App& app, RgbdOptions& options)
{
  app.add_flag("--no-poses", options.no_poses, "Leave poses out, known or not");
}

void
addMaxDepth(CLI::App& app, RgbdOptions& options)
{
  addPositive(app,
              "--max-depth",
              options.max_depth,
              "M",
              "Leave out points farther than this, metres [default: none]")
      ->default_str("");
}

void
addStampGap(CLI::App& app, RgbdOptions& options)
{
  addPositive(app,
              "--max-stamp-gap",
              options.max_stamp_gap,
              "S",
              "Seconds between what lists or names have of one moment, at most");
}

std::string
intrinsicsText(const RgbdOptions& options, const RgbdSequence& sequence)
{
  if (options.intrinsics.empty())
    return {};
  const CalibratedPinhole camera = loadCameraPinhole(options.intrinsics);
  const bool is_scaled =
      camera.width != 0 && camera.width != depthSizeOf(sequence).width;
  return camera.told +
         (is_scaled ? ", scaled from " + sizeText(camera) + " pixels" : "");
}

std::string
depthScaleText(const RgbdOptions& options,
               const RgbdSequence& sequence,
               const RgbdCameras& cameras)
{
  const std::string number = depthScaleText(cameras.meaning.scale) + " in a metre";
  return options.depth_scale
             ? number
             : number + ", as of " + sequence.layout + "; --depth-scale states another";
}

} // namespace pcl::acmap
