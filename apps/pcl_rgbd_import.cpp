#include "observation_folder.h"
#include "rgbd_import/import_options.h"
#include "rgbd_import/rgbd_observation.h"

#include <pcl/core/trajectory.h>

#include <cmath>
#include <numeric>

namespace {

using namespace pcl::acmap;

/** \brief Left-out frames are named up to here; the report names them all. */
constexpr std::size_t most_named = 5;

/** \brief What was done so far. */
struct Import {
  pcl::Trajectory trajectory; ///< T_first_camera; identity without poses
  Eigen::Isometry3d T_first_world;
  std::int32_t width = 0; ///< pixels, of all images
  std::int32_t height = 0;
  std::size_t empty = 0; ///< observations without a point
  std::vector<std::uint64_t> depths = std::vector<std::uint64_t>(65536); ///< histogram
  std::vector<std::string> broken; ///< why frames were left out

  std::uint64_t
  points() const
  {
    return std::accumulate(depths.begin(), depths.end(), std::uint64_t{0});
  }

  /** \brief Number in a depth image that half of the points do not exceed. */
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

std::string
sizeText(std::int32_t width, std::int32_t height)
{
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

void
requireSize(const std::string& path,
            std::int32_t width,
            std::int32_t height,
            std::int32_t needed_width,
            std::int32_t needed_height)
{
  if (width != needed_width || height != needed_height)
    throw pcl::InputFileException(path + ": has " + sizeText(width, height) +
                                  ", the images before have " +
                                  sizeText(needed_width, needed_height));
}

struct FrameImages {
  pcl::RgbImage color;
  pcl::GrayImage16 depth;
};

FrameImages
loadImages(const RgbdFrame& frame, const Import& import)
{
  FrameImages images{pcl::loadRgbImage(frame.color), pcl::loadGrayImage16(frame.depth)};
  const pcl::RgbImage& color = images.color;
  const pcl::GrayImage16& depth = images.depth;
  if (import.width > 0)
    requireSize(frame.color, color.width, color.height, import.width, import.height);
  requireSize(frame.depth, depth.width, depth.height, color.width, color.height);
  return images;
}

/** \brief Pose in the map, which is the frame of the first camera that is written. */
Eigen::Isometry3d
poseInMap(const Eigen::Isometry3d& T_world_camera, Import& import)
{
  if (import.trajectory.poses.empty()) {
    import.T_first_world = T_world_camera.inverse();
    return Eigen::Isometry3d::Identity();
  }
  return import.T_first_world * T_world_camera;
}

std::uint64_t
countDepths(const pcl::GrayImage16& depth, const DepthMeaning& meaning, Import& import)
{
  std::uint64_t points = 0;
  for (const std::uint16_t number : depth.values)
    if (meaning.metres(number) > 0.0) {
      ++import.depths[number];
      ++points;
    }
  return points;
}

/** \brief Reads and checks all of a frame before anything of it is counted or written. */
void
importFrame(const RgbdFrame& frame,
            bool has_poses,
            const Pinhole& camera,
            const DepthMeaning& meaning,
            const OutputFolder& folder,
            Import& import)
{
  const Eigen::Isometry3d T_world_camera =
      has_poses ? poseOf(frame) : Eigen::Isometry3d::Identity();
  const FrameImages images = loadImages(frame, import);
  const Eigen::Isometry3d T_map_camera = poseInMap(T_world_camera, import);
  saveObservation(folder.path(observationName(import.trajectory.poses.size())),
                  observationCloud(images.color, images.depth, camera, meaning),
                  T_map_camera);
  if (countDepths(images.depth, meaning, import) == 0)
    ++import.empty;
  import.width = images.depth.width;
  import.height = images.depth.height;
  import.trajectory.stamps.push_back(frame.stamp);
  import.trajectory.poses.push_back(T_map_camera);
}

void
importFrames(Tool& tool,
             const ImportOptions& options,
             const std::vector<RgbdFrame>& frames,
             const Pinhole& camera,
             const DepthMeaning& meaning,
             const OutputFolder& folder,
             Import& import)
{
  tool.withProgress([&](const pcl::ProgressCallback& progress) {
    const Progress told(progress);
    for (std::size_t i = 0; i < frames.size(); i += options.every) {
      told.tell(static_cast<double>(i) / static_cast<double>(frames.size()),
                "importing");
      try {
        importFrame(frames[i], !options.no_poses, camera, meaning, folder, import);
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
warnOfOddities(Tool& tool,
               const RgbdSequence& sequence,
               const Pinhole& camera,
               const Import& import)
{
  for (const std::string& remark : sequence.remarks)
    tool.warn(remark);
  if (std::abs(2 * camera.cx - import.width) > 0.5 * import.width ||
      std::abs(2 * camera.cy - import.height) > 0.5 * import.height)
    tool.warn("the camera's principal point " + shortNumber(camera.cx) + ", " +
              shortNumber(camera.cy) + " is far from the middle of images of " +
              sizeText(import.width, import.height) + "; --intrinsics names another");
  const auto count = [&](std::size_t frames, const std::string& fault) {
    if (frames > 0)
      tool.warn(std::to_string(frames) + fault);
  };
  count(sequence.unmatched,
        " depth images left out: no colour image was taken near them");
  count(sequence.unposed, " frames left out: no pose is known near them");
  count(import.empty, " observations have no point at all");
  for (std::size_t i = 0; i < std::min(most_named, import.broken.size()); ++i)
    tool.warn("left out: " + import.broken[i]);
  if (import.broken.size() > most_named)
    tool.warn(std::to_string(import.broken.size() - most_named) +
              " further frames left out, the report names them");
}

void
tellResults(Tool& tool,
            const ImportOptions& options,
            const RgbdSequence& sequence,
            const Import& import,
            double depth_scale)
{
  const std::size_t observations = import.trajectory.poses.size();
  const std::uint64_t points = import.points();
  const double pixels =
      static_cast<double>(observations) * import.width * import.height;
  const double share = static_cast<double>(points) / pixels;
  const double median = import.medianDepth() / depth_scale;
  tool.details() = {{"input", options.input},
                    {"output", options.output},
                    {"layout", sequence.layout},
                    {"observations", observations},
                    {"width", import.width},
                    {"height", import.height},
                    {"points", points},
                    {"finite_share", share},
                    {"median_depth", median},
                    {"has_poses", !options.no_poses},
                    {"unmatched", sequence.unmatched},
                    {"unposed", sequence.unposed},
                    {"broken", import.broken}};
  tool.tell("layout", sequence.layout);
  tool.tell("observations", std::to_string(observations));
  tool.tell("points", std::to_string(points));
  tool.tell("finite", shortNumber(100.0 * share) + " % of the pixels");
  tool.tell("median depth", shortNumber(median) + " m");
  if (!import.broken.empty())
    tool.tell("left out", std::to_string(import.broken.size()) + " broken frames");
  tool.tell("folder", options.output);
}

void
convert(Tool& tool, const ImportOptions& options)
{
  StepTimer timer(tool.report());
  const RgbdSequence sequence = openSequence(options.input, settingsOf(options));
  const Pinhole camera = cameraOf(options, sequence);
  const DepthMeaning meaning{options.depth_scale.value_or(sequence.depth_scale),
                             options.most_depth};
  OutputFolder folder(options.output);
  if (folder.holds(options.input + "/any"))
    throw UsageError(options.output + ": is the input's folder, too");
  requireNoSequence(folder);
  tool.requireReportWritable({});
  timer.finish("list");

  Import import;
  importFrames(tool, options, sequence.frames, camera, meaning, folder, import);
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
  warnOfOddities(tool, sequence, camera, import);
  tellResults(tool, options, sequence, import, meaning.scale);
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
