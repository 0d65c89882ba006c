#include "command_line.h"
#include "output_target.h"
#include "pose_options.h"
#include "rgbd_import/rgbd_options.h"
#include "tool.h"

#include <pcl/core/impl/part_of_progress.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/observation_files.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/rgbd_import.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <utility>

namespace pcl::acmap {

namespace {

/** Fraction of the progress after which the poses are checked. */
constexpr double checked = 0.2;

/** \brief Options of the user. */
struct ImportOptions : RgbdOptions {
  std::string input;
  std::string output;
  bool skip_broken = false;
  DepthSensor sensor = DepthSensor::Automatic;
  PoseConventionCheck poses;
  std::size_t every = 1;
};

void
addOptions(Tool& tool, ImportOptions& options)
{
  CLI::App& app = tool.options();
  app.add_option(
         "input",
         options.input,
         "RGB-D folder: rgb.txt, depth.txt, groundtruth.txt as of TUM; "
         "associations.txt as of ORB-SLAM; frame-000000.color.jpg, .depth.png, "
         ".pose.txt as of 7-Scenes; folders color, depth, pose, intrinsic as of "
         "ScanNet; results, traj.txt as of Replica; depth, odometry.csv as of "
         "StrayScanner; metadata.json as of Record3D; or folders color and "
         "depth, camera_intrinsic.json, trajectory.log as of Open3D")
      ->type_name("DIR")
      ->required();
  app.add_option("-o,--output", options.output, "Folder for the observations")
      ->type_name("OBS_DIR")
      ->required();
  addNoPoses(app, options);
  addPoseReading(app, options.poses);
  app.add_flag("--skip-broken",
               options.skip_broken,
               "Leave out frames with a missing or damaged file instead of giving up");
  addRgbdCameras(app, options);
  addMaxDepth(app, options);
  tool.addSensor(options.sensor);
  app.add_option("--every", options.every, "Take only each Nth frame")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 31).description(""));
  addStampGap(app, options);
}

/** \brief Source of the colour camera's parameters. */
std::string
colorCameraText(const ImportOptions& options,
                const RgbdCameras& cameras,
                const std::string& layout)
{
  if (!cameras.color)
    return "none";
  return options.color_camera.empty() ? layout : options.color_camera;
}

void
tellResults(const ImportOptions& options,
            const RgbdSequence& sequence,
            const RgbdCameras& cameras,
            const RgbdImport& import,
            StageLog& log)
{
  const std::size_t observations = import.trajectory.poses.size();
  const std::string colors = colorCameraText(options, cameras, sequence.layout);
  log.details = {{"input", options.input},
                 {"output", options.output},
                 {"layout", sequence.layout},
                 {"observations", observations},
                 {"width", import.size.width},
                 {"height", import.size.height},
                 {"color_camera", colors},
                 {"points", import.points},
                 {"refined", import.refined},
                 {"finite_share", import.finite_share},
                 {"median_depth", import.median_depth},
                 {"depth_scale", cameras.meaning.scale},
                 {"has_poses", sequence.has_poses},
                 {"unmatched", sequence.unmatched},
                 {"unposed", sequence.unposed},
                 {"broken", import.broken}};
  log.tell("layout", sequence.layout);
  log.tell("colour camera", colors);
  if (const std::string text = intrinsicsText(options, sequence); !text.empty())
    log.tell("intrinsics", text);
  log.tell("depth scale", depthScaleText(options, sequence, cameras));
  log.tell("observations", std::to_string(observations));
  log.tell("points", std::to_string(import.points));
  log.tell("finite", shortNumber(100.0 * import.finite_share) + " % of the pixels");
  log.tell("median depth", shortNumber(import.median_depth) + " m");
  if (import.refined > 0)
    log.tell("refined",
             "the quantised depth of " + std::to_string(import.refined) +
                 " observations");
  if (!import.broken.empty())
    log.tell("left out", std::to_string(import.broken.size()) + " broken frames");
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
        const std::optional<PoseConventionReport>& poses,
        OutputFolder& folder,
        const RunControls& controls,
        StageLog& log)
{
  StepTimer timer(log.report);
  const RgbdImport import = importRgbd(sequence,
                                       cameras,
                                       folder,
                                       {options.every,
                                        options.skip_broken,
                                        controls.threads,
                                        partOf(controls.progress, checked, 1)});
  if (import.trajectory.poses.empty())
    throw NothingFound(options.input +
                       ": no frame is whole, the first: " + import.broken.front());
  if (import.points == 0)
    throw NothingFound(options.input + ": no depth image has a point in reach");
  timer.finish("import");

  if (sequence.has_poses)
    saveTrajectory(folder.path(trajectory_name), import.trajectory);
  stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  log.warn(rgbdRemarks(options, sequence, cameras));
  log.warn(import.remarks);
  std::vector<std::string> left_out;
  for (const std::string& reason : import.broken)
    left_out.push_back("left out: " + reason);
  log.warnOfFirst(5, left_out, "further frames left out, the report names them");
  tellResults(options, sequence, cameras, import, log);
  tellPoseReading(options.poses, poses, log);
  log.tell("folder", options.output);
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
  tool.setHelp({{{"pcl_rgbd_import recording -o clouds",
                  "Point clouds of an RGB-D folder, with its poses if it has some."}},
                {}});
  return tool.run(argc, argv, [&] {
    StageLog& log = tool.log();
    StepTimer timer(log.report);
    pcl::RgbdSequence sequence = openRgbdSequence(options.input, settingsOf(options));
    const pcl::RgbdCameras cameras = camerasOf(options, sequence, options.sensor);
    OutputFolder folder(options.output);
    checkPlaces(tool, options, folder);
    timer.finish("list");
    pcl::PoseConventionCheck check = options.poses;
    check.setNumberOfThreads(tool.controls().threads);
    check.setProgressCallback(partOf(tool.controls().progress, 0, checked));
    const auto poses = readRecordedPoses(std::move(check), cameras, sequence);
    timer.finish("check poses");
    convert(options, sequence, cameras, poses, folder, tool.controls(), log);
  });
}
