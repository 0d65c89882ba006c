#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/output_folder.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/observation_writing.h>
#include <pcl/pipeline/rgbd_import.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <utility>

namespace pcl {

namespace {

/** Histogram of the numbers in the depth images over all points. */
class DepthHistogram {
public:
  /** \param[in] scale number of a metre */
  explicit DepthHistogram(double scale)
  : scale_(scale)
  {}

  /** \return number of points */
  std::size_t
  add(const PCLPointCloud2& cloud)
  {
    const std::size_t offset = acmap::findField(cloud, "z")->offset;
    const auto maximum = static_cast<double>(counts_.size() - 1);
    std::size_t points = 0;
    for (std::size_t i = 0; i < acmap::rowsOf(cloud); ++i) {
      float z = 0;
      std::memcpy(&z, &cloud.data[i * cloud.point_step + offset], sizeof z);
      if (!(z > 0.0F))
        continue;
      const double number = std::min(std::round(z * scale_), maximum);
      ++counts_[static_cast<std::size_t>(number)];
      ++points;
    }
    return points;
  }

  /** Metres. */
  double
  median() const
  {
    const std::uint64_t points =
        std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
    std::uint64_t left = (points + 1) / 2;
    std::size_t number = 0;
    while (number + 1 < counts_.size() && counts_[number] < left)
      left -= counts_[number++];
    return static_cast<double>(number) / scale_;
  }

private:
  double scale_;
  std::vector<std::uint64_t> counts_ = std::vector<std::uint64_t>(65536);
};

void
noteCenter(const std::string& name,
           const Pinhole& camera,
           const ImageSize& size,
           const std::string& option,
           std::vector<std::string>& remarks)
{
  if (std::abs(2 * camera.cx - size.width) > 0.5 * size.width ||
      std::abs(2 * camera.cy - size.height) > 0.5 * size.height)
    remarks.push_back(
        "the " + name + "'s principal point " + acmap::shortNumber(camera.cx) + ", " +
        acmap::shortNumber(camera.cy) + " is far from the middle of images of " +
        acmap::sizeText(size) + " pixels; " + option + " names another");
}

std::vector<std::string>
remarksOn(const RgbdImport& import, const RgbdCameras& cameras)
{
  std::vector<std::string> remarks;
  noteCenter("camera", cameras.depth, import.sizes.depth, "--intrinsics", remarks);
  if (cameras.color)
    noteCenter("colour camera",
               cameras.color->pinhole,
               import.sizes.color,
               "--color-camera",
               remarks);
  constexpr double farthest_pose = 1000; // metres; their unit is then probably wrong
  double farthest = 0;
  for (const Eigen::Isometry3d& T_map_camera : import.trajectory.poses)
    farthest = std::max(farthest, T_map_camera.translation().norm());
  if (farthest > farthest_pose)
    remarks.push_back("the camera moves " + acmap::shortNumber(farthest) +
                      " m away from its first place: are the poses in metres?");
  if (import.empty > 0)
    remarks.push_back(std::to_string(import.empty) +
                      " observations have no point at all");
  return remarks;
}

/** Converts the frames of a recording, one after another. */
class RgbdImporter {
public:
  RgbdImporter(const RgbdSequence& sequence,
               const RgbdCameras& cameras,
               unsigned threads)
  : sequence_(sequence)
  , cameras_(cameras)
  , threads_(threads)
  , depths_(cameras.meaning.scale)
  {}

  /** All of the frame is read and checked before anything is counted. */
  acmap::ObservationToWrite
  convert(const RgbdFrame& frame)
  {
    const Eigen::Isometry3d T_world_camera =
        sequence_.has_poses ? loadPose(frame, cameras_) : Eigen::Isometry3d::Identity();
    RgbdObservation observation =
        loadRgbdObservation(frame, cameras_, import_.sizes, threads_);
    const bool is_first = !T_first_world_;
    if (is_first)
      T_first_world_ = T_world_camera.inverse();
    const std::size_t points = depths_.add(observation.cloud);
    import_.points += points;
    import_.empty += points == 0 ? 1 : 0;
    import_.refined += observation.is_refined ? 1 : 0;
    import_.sizes = observation.sizes;
    import_.size = {static_cast<std::int32_t>(observation.cloud.width),
                    static_cast<std::int32_t>(observation.cloud.height)};
    return {std::make_shared<PCLPointCloud2>(std::move(observation.cloud)),
            is_first ? Eigen::Isometry3d::Identity()
                     : Eigen::Isometry3d(*T_first_world_ * T_world_camera),
            frame.stamp};
  }

  void
  leaveOut(const std::string& reason)
  {
    import_.broken.push_back(reason);
  }

  RgbdImport
  finish(Trajectory written)
  {
    import_.trajectory = std::move(written);
    const double pixels = static_cast<double>(import_.trajectory.poses.size()) *
                          import_.size.width * import_.size.height;
    import_.finite_share =
        pixels > 0 ? static_cast<double>(import_.points) / pixels : 0;
    import_.median_depth = import_.points > 0 ? depths_.median() : 0;
    import_.remarks = remarksOn(import_, cameras_);
    return std::move(import_);
  }

private:
  const RgbdSequence& sequence_;
  const RgbdCameras& cameras_;
  unsigned threads_;
  DepthHistogram depths_;
  std::optional<Eigen::Isometry3d> T_first_world_;
  RgbdImport import_;
};

} // namespace

RgbdImport
importRgbd(const RgbdSequence& sequence,
           const RgbdCameras& cameras,
           const acmap::OutputFolder& folder,
           const RgbdImportSettings& settings)
{
  RgbdImporter importer(sequence, cameras, settings.threads);
  const std::size_t every = std::max<std::size_t>(settings.every, 1);
  const auto convert = [&](std::size_t i) -> std::optional<acmap::ObservationToWrite> {
    try {
      return importer.convert(sequence.frames[i * every]);
    }
    catch (const InputFileException& fault) {
      if (!settings.skip_broken)
        throw;
      importer.leaveOut(fault.what());
      return {};
    }
  };
  const std::size_t count =
      sequence.frames.size() / every + (sequence.frames.size() % every > 0 ? 1 : 0);
  return importer.finish(acmap::writeObservations(
      folder, count, convert, {settings.progress, "importing"}));
}

std::optional<PoseConventionReport>
readRecordedPoses(PoseConventionCheck check,
                  const RgbdCameras& cameras,
                  RgbdSequence& sequence)
{
  if (!sequence.has_poses)
    return {};
  RgbdSequence posed = sequence;
  posed.frames.clear();
  std::vector<RgbdFrame*> read;
  for (RgbdFrame& frame : sequence.frames)
    try {
      frame.T_world_camera = loadPose(frame);
      posed.frames.push_back(frame);
      read.push_back(&frame);
    }
    catch (const InputFileException&) {
      continue;
    }
  if (posed.frames.empty())
    return {};
  check.compute(ObservationSequence(posed, cameras, check.getNumberOfThreads()));
  const PoseReading& stated = check.getReport().stated;
  for (RgbdFrame* const frame : read)
    frame->T_world_camera = readPose(*frame->T_world_camera, stated);
  return check.getReport();
}

} // namespace pcl
