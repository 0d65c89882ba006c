#include "output_target.h"
#include "rgbd_import/frame_import.h"
#include "rgbd_import/import_options.h"

#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::acmap;

/** \brief Maximum number of left-out frames in warnings; the report names them all. */
constexpr std::size_t max_named = 5;

void
importFrames(Tool& tool,
             const ImportOptions& options,
             const std::vector<pcl::RgbdFrame>& frames,
             const pcl::RgbdCameras& cameras,
             const OutputFolder& folder,
             RgbdImport& import)
{
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const Progress told(progress);
    for (std::size_t i = 0; i < frames.size(); i += options.every) {
      told.tell(static_cast<double>(i) / static_cast<double>(frames.size()),
                "importing");
      try {
        importFrame(
            frames[i], !options.no_poses, cameras, folder, tool.threads(), import);
      }
      catch (const pcl::InputFileException& fault) {
        if (!options.skip_broken)
          throw;
        import.broken.push_back(failureOf(std::current_exception()).line);
      }
    }
  });
}

void
warnOfCenter(Tool& tool,
             const std::string& name,
             const pcl::Pinhole& camera,
             const pcl::ImageSize& size,
             const std::string& option)
{
  if (std::abs(2 * camera.cx - size.width) > 0.5 * size.width ||
      std::abs(2 * camera.cy - size.height) > 0.5 * size.height)
    tool.warn("the " + name + "'s principal point " + shortNumber(camera.cx) + ", " +
              shortNumber(camera.cy) + " is far from the middle of images of " +
              sizeText(size) + "; " + option + " names another");
}

void
warnOfCameras(Tool& tool,
              const ImportOptions& options,
              const pcl::RgbdSequence& sequence,
              const pcl::RgbdCameras& cameras,
              const RgbdImport& import)
{
  for (const std::string& remark : sequence.remarks)
    tool.warn(remark);
  warnOfCenter(tool, "camera", cameras.depth, import.sizes.depth, "--intrinsics");
  if (cameras.color)
    warnOfCenter(tool,
                 "colour camera",
                 cameras.color->pinhole,
                 import.sizes.color,
                 "--color-camera");
  else if (!sequence.is_registered && !options.is_registered)
    tool.warn("the camera of the colours is not known: took them pixel by pixel as the "
              "depths; --color-camera names it, --registered says that this is right");
}

/** Warns of lengths that exceed rooms, since the unit of the numbers is then probably
 * wrong. */
void
warnOfLengths(Tool& tool, const pcl::RgbdCameras& cameras, const RgbdImport& import)
{
  constexpr double farthest_depth = 100, farthest_pose = 1000;
  const double depth = import.medianDepth() / cameras.meaning.scale;
  if (depth > farthest_depth)
    tool.warn("half of the points are farther than " + shortNumber(depth) +
              " m: are there " + shortNumber(cameras.meaning.scale) +
              " of the depth images' numbers in a metre? --depth-scale tells");
  double pose = 0;
  for (const Eigen::Isometry3d& T_map_camera : import.trajectory.poses)
    pose = std::max(pose, T_map_camera.translation().norm());
  if (pose > farthest_pose)
    tool.warn("the camera moves " + shortNumber(pose) +
              " m away from its first place: are the poses in metres?");
}

void
warnOfFrames(Tool& tool, const pcl::RgbdSequence& sequence, const RgbdImport& import)
{
  const auto count = [&](std::size_t frames, const std::string& fault) {
    if (frames > 0)
      tool.warn(std::to_string(frames) + fault);
  };
  count(sequence.unmatched,
        " depth images left out: no colour image was taken near them");
  count(sequence.unposed, " frames left out: no pose is known near them");
  count(import.empty, " observations have no point at all");
  for (std::size_t i = 0; i < std::min(max_named, import.broken.size()); ++i)
    tool.warn("left out: " + import.broken[i]);
  if (import.broken.size() > max_named)
    tool.warn(std::to_string(import.broken.size() - max_named) +
              " further frames left out, the report names them");
}

/** \brief Source of the colour camera's parameters. */
std::string
colorCameraText(const ImportOptions& options, const pcl::RgbdCameras& cameras)
{
  if (!cameras.color)
    return "none";
  return options.color_camera.empty() ? "7-Scenes" : options.color_camera;
}

void
tellResults(Tool& tool,
            const ImportOptions& options,
            const pcl::RgbdSequence& sequence,
            const pcl::RgbdCameras& cameras,
            const RgbdImport& import)
{
  const std::size_t observations = import.trajectory.poses.size();
  const std::uint64_t points = import.points();
  const double pixels = static_cast<double>(observations) * import.sizes.color.width *
                        import.sizes.color.height;
  const double share = static_cast<double>(points) / pixels;
  const double median = import.medianDepth() / cameras.meaning.scale;
  const std::string colors = colorCameraText(options, cameras);
  tool.details() = {{"input", options.input},
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
  tool.tell("layout", sequence.layout);
  tool.tell("colour camera", colors);
  tool.tell("observations", std::to_string(observations));
  tool.tell("points", std::to_string(points));
  tool.tell("finite", shortNumber(100.0 * share) + " % of the pixels");
  tool.tell("median depth", shortNumber(median) + " m");
  if (import.refined > 0)
    tool.tell("refined",
              "the quantised depth of " + std::to_string(import.refined) +
                  " observations");
  if (!import.broken.empty())
    tool.tell("left out", std::to_string(import.broken.size()) + " broken frames");
  tool.tell("folder", options.output);
}

void
convert(Tool& tool, const ImportOptions& options)
{
  StepTimer timer(tool.report());
  const pcl::RgbdSequence sequence =
      pcl::openRgbdSequence(options.input, settingsOf(options));
  const pcl::RgbdCameras cameras{
      cameraOf(options, sequence),
      colorCameraOf(options, sequence),
      {options.depth_scale.value_or(sequence.depth_scale), options.max_depth},
      options.sensor};
  OutputFolder folder(options.output);
  if (folder.holds(options.input + "/any"))
    throw UsageError(options.output + ": is the input's folder, too");
  requireNoSequence(folder);
  tool.requireReportWritable({});
  timer.finish("list");

  RgbdImport import;
  importFrames(tool, options, sequence.frames, cameras, folder, import);
  if (import.trajectory.poses.empty())
    throw NothingFound(options.input +
                       ": no frame is whole, the first: " + import.broken.front());
  if (import.points() == 0)
    throw NothingFound(options.input + ": no depth image has a point in reach");
  timer.finish("import");

  if (!options.no_poses)
    pcl::saveTrajectory(folder.path(trajectory_name), import.trajectory);
  tool.stopIfInterrupted();
  folder.commit();
  timer.finish("write");
  warnOfCameras(tool, options, sequence, cameras, import);
  warnOfLengths(tool, cameras, import);
  warnOfFrames(tool, sequence, import);
  tellResults(tool, options, sequence, cameras, import);
}

} // namespace

int
main(int argc, char** argv)
{
  Tool tool("pcl_rgbd_import",
            "Turns a folder of colour and depth images into observation point clouds.");
  ImportOptions options;
  addOptions(tool, options);
  return tool.run(argc, argv, [&] { convert(tool, options); });
}
