#include "command_line.h"
#include "output_target.h"
#include "tool.h"

#include <pcl/core/calibration_file.h>
#include <pcl/core/image_file.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/observation_writing.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numeric>
#include <optional>

namespace pcl::acmap {

namespace {

/** \brief Options of the user. */
struct ImportOptions {
  std::string input;
  std::string output;
  bool no_poses = false;
  bool skip_broken = false;
  std::string intrinsics;
  std::string color_camera;
  bool is_registered = false;
  std::optional<double> fx, fy, cx, cy; ///< pixels
  std::optional<double> depth_scale;    ///< number in a depth image that is one metre
  double max_depth = 0.0;               ///< metres; 0 for no limit
  DepthSensor sensor = DepthSensor::Automatic;
  std::size_t every = 1;
  double max_stamp_gap = RgbdSequenceSettings().max_stamp_gap; ///< seconds
};

/** \brief Results so far. */
struct RgbdImport {
  Trajectory trajectory; ///< T_first_camera; identity without poses
  std::optional<Eigen::Isometry3d> T_first_world;
  RgbdImageSizes sizes;    ///< of the images of all frames
  std::size_t empty = 0;   ///< observations without a point
  std::size_t refined = 0; ///< observations whose depth was quantised
  /** \brief Histogram of the numbers in the depth images over all points. */
  std::vector<std::uint64_t> depths = std::vector<std::uint64_t>(65536);
  std::vector<std::string> broken; ///< reasons why frames were left out

  std::uint64_t
  points() const
  {
    return std::accumulate(depths.begin(), depths.end(), std::uint64_t{0});
  }

  /** \brief Median of the numbers in the depth images over all points. */
  std::uint16_t
  medianDepth() const
  {
    std::uint64_t left = (points() + 1) / 2;
    std::size_t number = 0;
    while (number + 1 < depths.size() && depths[number] < left)
      left -= depths[number++];
    return static_cast<std::uint16_t>(number);
  }
};

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

void
addCameras(CLI::App& app, ImportOptions& options)
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
  addPositive(app,
              "--depth-scale",
              options.depth_scale,
              "N",
              "Numbers of a depth image in a metre [default: 5000 for TUM, 1000 for "
              "7-Scenes and Open3D]");
  addPositive(app,
              "--max-depth",
              options.max_depth,
              "M",
              "Leave out points farther than this, metres [default: none]")
      ->default_str("");
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

void
addOptions(Tool& tool, ImportOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option("input",
                 options.input,
                 "RGB-D folder: rgb.txt, depth.txt, groundtruth.txt as of TUM; "
                 "frame-000000.color.jpg, .depth.png, .pose.txt as of 7-Scenes; or "
                 "folders color and depth, camera_intrinsic.json, trajectory.log as of "
                 "Open3D")
      ->type_name("DIR")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the observations")
      ->type_name("OBS_DIR")
      ->required();
  app.add_flag("--no-poses", options.no_poses, "Leave poses out, known or not");
  app.add_flag("--skip-broken",
               options.skip_broken,
               "Leave out frames with a missing or damaged file instead of giving up");
  addCameras(app, options);
  tool.addSensor(options.sensor);
  app.add_option("--every", options.every, "Take only each Nth frame")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  addPositive(app,
              "--max-stamp-gap",
              options.max_stamp_gap,
              "S",
              "Seconds between what TUM's lists have of one moment, at most");
}

/** \brief Settings for reading the folder. */
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

/** \brief Size of the first depth image that can be read. */
ImageSize
depthSizeOf(const ImportOptions& options, const RgbdSequence& sequence)
{
  for (std::size_t i = 0;; ++i)
    try {
      const GrayImage16 image = loadGrayImage16(sequence.frames.at(i).depth);
      return {image.width, image.height};
    }
    catch (const InputFileException&) {
      if (!options.skip_broken || i + 1 >= sequence.frames.size())
        throw;
    }
}

/** \brief The depth camera of the user's file, for images of the folder's size. */
Pinhole
loadDepthCamera(const ImportOptions& options,
                const RgbdSequence& sequence,
                StageLog& log)
{
  const CalibratedPinhole camera = loadCameraPinhole(options.intrinsics);
  const ImageSize size = depthSizeOf(options, sequence);
  const bool is_scaled = camera.width != 0 && camera.width != size.width;
  log.tell("intrinsics",
           camera.told +
               (is_scaled ? ", scaled from " + sizeText(camera) + " pixels" : ""));
  return fittedPinhole(camera, size.width, size.height, options.intrinsics);
}

/** \brief The cameras of the user, otherwise those of the folder; no colour camera if
 * colours have the pixels of the depth camera. */
RgbdCameras
camerasOf(const ImportOptions& options, const RgbdSequence& sequence, StageLog& log)
{
  Pinhole depth = options.intrinsics.empty() ? sequence.camera
                                             : loadDepthCamera(options, sequence, log);
  if (options.fx)
    depth.fx = depth.fy = *options.fx;
  depth.fy = options.fy.value_or(depth.fy);
  depth.cx = options.cx.value_or(depth.cx);
  depth.cy = options.cy.value_or(depth.cy);
  std::optional<ColorCamera> color = sequence.color_camera;
  if (options.is_registered)
    color.reset();
  else if (!options.color_camera.empty())
    color = loadColorCamera(options.color_camera);
  return {depth,
          color,
          {options.depth_scale.value_or(sequence.depth_scale), options.max_depth},
          options.sensor};
}

/** \brief Pose in the map, which is the frame of the first written camera. */
Eigen::Isometry3d
poseInMap(const Eigen::Isometry3d& T_world_camera, RgbdImport& import)
{
  if (!import.T_first_world) {
    import.T_first_world = T_world_camera.inverse();
    return Eigen::Isometry3d::Identity();
  }
  return *import.T_first_world * T_world_camera;
}

void
countDepths(const PCLPointCloud2& cloud, double depth_scale, RgbdImport& import)
{
  const std::size_t offset = findField(cloud, "z")->offset;
  const auto maximum = static_cast<double>(import.depths.size() - 1);
  bool is_empty = true;
  for (std::size_t i = 0; i < rowsOf(cloud); ++i) {
    float z = 0;
    std::memcpy(&z, &cloud.data[i * cloud.point_step + offset], sizeof z);
    if (!(z > 0.0F))
      continue;
    const double number = std::min(std::round(z * depth_scale), maximum);
    ++import.depths[static_cast<std::size_t>(number)];
    is_empty = false;
  }
  if (is_empty)
    ++import.empty;
}

/** \brief Converts a frame to an observation. All of the frame is read and checked before
 * anything is counted.
 * \throws InputFileException when an image or the pose is missing, malformed, or
 * differs in size from the previous ones */
ObservationToWrite
importFrame(const RgbdFrame& frame,
            bool has_poses,
            const RgbdCameras& cameras,
            unsigned threads,
            RgbdImport& import)
{
  const Eigen::Isometry3d T_world_camera =
      has_poses ? loadPose(frame, cameras) : Eigen::Isometry3d::Identity();
  RgbdObservation observation =
      loadRgbdObservation(frame, cameras, import.sizes, threads);
  const Eigen::Isometry3d T_map_camera = poseInMap(T_world_camera, import);
  countDepths(observation.cloud, cameras.meaning.scale, import);
  import.refined += observation.is_refined ? 1 : 0;
  import.sizes = observation.sizes;
  return {std::make_shared<PCLPointCloud2>(std::move(observation.cloud)),
          T_map_camera,
          frame.stamp};
}

void
importFrames(const ImportOptions& options,
             const std::vector<RgbdFrame>& frames,
             const RgbdCameras& cameras,
             const OutputFolder& folder,
             const RunControls& controls,
             RgbdImport& import)
{
  const auto convert = [&](std::size_t i) -> std::optional<ObservationToWrite> {
    try {
      return importFrame(frames[i * options.every],
                         !options.no_poses,
                         cameras,
                         controls.threads,
                         import);
    }
    catch (const InputFileException&) {
      if (!options.skip_broken)
        throw;
      import.broken.push_back(failureOf(std::current_exception()).line);
      return {};
    }
  };
  const std::size_t count = (frames.size() + options.every - 1) / options.every;
  import.trajectory =
      writeObservations(folder, count, convert, {controls.progress, "importing"});
}

void
warnOfCenter(const std::string& name,
             const Pinhole& camera,
             const ImageSize& size,
             const std::string& option,
             StageLog& log)
{
  if (std::abs(2 * camera.cx - size.width) > 0.5 * size.width ||
      std::abs(2 * camera.cy - size.height) > 0.5 * size.height)
    log.warn("the " + name + "'s principal point " + shortNumber(camera.cx) + ", " +
             shortNumber(camera.cy) + " is far from the middle of images of " +
             sizeText(size) + " pixels; " + option + " names another");
}

void
warnOfCameras(const ImportOptions& options,
              const RgbdSequence& sequence,
              const RgbdCameras& cameras,
              const RgbdImport& import,
              StageLog& log)
{
  log.warn(sequence.remarks);
  warnOfCenter("camera", cameras.depth, import.sizes.depth, "--intrinsics", log);
  if (cameras.color)
    warnOfCenter("colour camera",
                 cameras.color->pinhole,
                 import.sizes.color,
                 "--color-camera",
                 log);
  else if (!sequence.is_registered && !options.is_registered)
    log.warn("the camera of the colours is not known: took them pixel by pixel as the "
             "depths; --color-camera names it, --registered says that this is right");
}

/** Warns of lengths that exceed rooms, since the unit of the numbers is then probably
 * wrong. */
void
warnOfLengths(const RgbdCameras& cameras, const RgbdImport& import, StageLog& log)
{
  constexpr double farthest_depth = 100, farthest_pose = 1000;
  const double depth = import.medianDepth() / cameras.meaning.scale;
  if (depth > farthest_depth)
    log.warn("half of the points are farther than " + shortNumber(depth) +
             " m: are there " + shortNumber(cameras.meaning.scale) +
             " of the depth images' numbers in a metre? --depth-scale tells");
  double pose = 0;
  for (const Eigen::Isometry3d& T_map_camera : import.trajectory.poses)
    pose = std::max(pose, T_map_camera.translation().norm());
  if (pose > farthest_pose)
    log.warn("the camera moves " + shortNumber(pose) +
             " m away from its first place: are the poses in metres?");
}

void
warnOfFrames(const RgbdSequence& sequence, const RgbdImport& import, StageLog& log)
{
  const auto count = [&](std::size_t frames, const std::string& fault) {
    if (frames > 0)
      log.warn(std::to_string(frames) + fault);
  };
  count(sequence.unmatched,
        " depth images left out: no colour image was taken near them");
  count(sequence.unposed, " frames left out: no pose is known near them");
  count(import.empty, " observations have no point at all");
  constexpr std::size_t max_named = 5; // the report names them all
  for (std::size_t i = 0; i < std::min(max_named, import.broken.size()); ++i)
    log.warn("left out: " + import.broken[i]);
  if (import.broken.size() > max_named)
    log.warn(std::to_string(import.broken.size() - max_named) +
             " further frames left out, the report names them");
}

/** \brief Source of the colour camera's parameters. */
std::string
colorCameraText(const ImportOptions& options, const RgbdCameras& cameras)
{
  if (!cameras.color)
    return "none";
  return options.color_camera.empty() ? "7-Scenes" : options.color_camera;
}

void
tellResults(const ImportOptions& options,
            const RgbdSequence& sequence,
            const RgbdCameras& cameras,
            const RgbdImport& import,
            StageLog& log)
{
  const std::size_t observations = import.trajectory.poses.size();
  const std::uint64_t points = import.points();
  const double pixels = static_cast<double>(observations) * import.sizes.color.width *
                        import.sizes.color.height;
  const double share = static_cast<double>(points) / pixels;
  const double median = import.medianDepth() / cameras.meaning.scale;
  const std::string colors = colorCameraText(options, cameras);
  log.details = {{"input", options.input},
                 {"output", options.output},
                 {"layout", sequence.layout},
                 {"observations", observations},
                 {"width", import.sizes.color.width},
                 {"height", import.sizes.color.height},
                 {"color_camera", colors},
                 {"points", points},
                 {"refined", import.refined},
                 {"finite_share", share},
                 {"median_depth", median},
                 {"has_poses", !options.no_poses},
                 {"unmatched", sequence.unmatched},
                 {"unposed", sequence.unposed},
                 {"broken", import.broken}};
  log.tell("layout", sequence.layout);
  log.tell("colour camera", colors);
  log.tell("observations", std::to_string(observations));
  log.tell("points", std::to_string(points));
  log.tell("finite", shortNumber(100.0 * share) + " % of the pixels");
  log.tell("median depth", shortNumber(median) + " m");
  if (import.refined > 0)
    log.tell("refined",
             "the quantised depth of " + std::to_string(import.refined) +
                 " observations");
  if (!import.broken.empty())
    log.tell("left out", std::to_string(import.broken.size()) + " broken frames");
  log.tell("folder", options.output);
}

void
checkPlaces(const Tool& tool, const ImportOptions& options, const OutputFolder& folder)
{
  if (folder.holds(options.input + "/any"))
    throw UsageError(options.output + ": is the input's folder, too");
  requireNoSequence(folder);
  tool.requireReportWritable({});
}

void
convert(const ImportOptions& options,
        const RgbdSequence& sequence,
        const RgbdCameras& cameras,
        OutputFolder& folder,
        const RunControls& controls,
        StageLog& log)
{
  StepTimer timer(log.report);
  RgbdImport import;
  importFrames(options, sequence.frames, cameras, folder, controls, import);
  if (import.trajectory.poses.empty())
    throw NothingFound(options.input +
                       ": no frame is whole, the first: " + import.broken.front());
  if (import.points() == 0)
    throw NothingFound(options.input + ": no depth image has a point in reach");
  timer.finish("import");

  if (!options.no_poses)
    saveTrajectory(folder.path(trajectory_name), import.trajectory);
  stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  warnOfCameras(options, sequence, cameras, import, log);
  warnOfLengths(cameras, import, log);
  warnOfFrames(sequence, import, log);
  tellResults(options, sequence, cameras, import, log);
}

} // namespace

} // namespace pcl::acmap

int
main(int argc, char** argv)
{
  using namespace pcl::acmap;
  Tool tool("pcl_rgbd_import",
            "Turns a folder of colour and depth images into observation point clouds.");
  ImportOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] {
    StageLog& log = tool.log();
    StepTimer timer(log.report);
    const pcl::RgbdSequence sequence =
        openRgbdSequence(options.input, settingsOf(options));
    const pcl::RgbdCameras cameras = camerasOf(options, sequence, log);
    OutputFolder folder(options.output);
    checkPlaces(tool, options, folder);
    timer.finish("list");
    convert(options, sequence, cameras, folder, tool.controls(), log);
  });
}
