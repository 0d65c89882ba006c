#include "rgbd/camera_path.h"
#include "rgbd/layouts.h"
#include "rgbd/stamp_matching.h"
#include "rgbd/text_rows.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/trajectory.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* color_list = "rgb.txt";
constexpr const char* depth_list = "depth.txt";
constexpr const char* pose_list = "groundtruth.txt";
constexpr Pinhole tum_camera = {525.0, 525.0, 319.5, 239.5};
constexpr double tum_depth_scale = 5000.0;

/** \brief Images with their stamps, sorted by stamp. */
struct ImageList {
  std::vector<double> stamps;
  std::vector<std::string> paths;
};

/** Is a path inside the folder? Lists may come from an untrusted source. */
bool
isInside(const fs::path& image)
{
  return image.is_relative() && *image.lexically_normal().begin() != "..";
}

ImageList
loadImageList(const fs::path& folder, const char* name)
{
  const std::string path = (folder / name).string();
  ImageList listed;
  for (const TextRow& row : loadTextRows(path)) {
    if (row.words.size() != 2)
      throw InputFileException(path + ": line " + std::to_string(row.line) + ": has " +
                               std::to_string(row.words.size()) +
                               " words, a stamp and a file are needed");
    listed.stamps.push_back(numberOf(path, row, 0));
    if (!isInside(row.words[1]))
      refuseWord(path, row, 1, "does not lie in the folder");
    listed.paths.push_back((folder / row.words[1]).string());
  }
  ImageList rising;
  for (const std::size_t i : risingOrder(listed.stamps)) {
    rising.stamps.push_back(listed.stamps[i]);
    rising.paths.push_back(listed.paths[i]);
  }
  if (rising.paths.empty())
    throw InputFileException(path + ": names no image");
  return rising;
}

void
findPoses(const fs::path& folder, double gap, RgbdSequence& sequence)
{
  const std::string path = (folder / pose_list).string();
  std::error_code error;
  if (!fs::exists(path, error))
    throw InputFileException(path + ": is missing; --no-poses does without it");
  const CameraPath camera_path(loadTrajectory(path), gap);
  std::vector<RgbdFrame> posed;
  for (RgbdFrame& frame : sequence.frames) {
    frame.T_world_camera = camera_path.at(frame.stamp);
    if (frame.T_world_camera)
      posed.push_back(frame);
  }
  sequence.unposed = sequence.frames.size() - posed.size();
  sequence.frames = std::move(posed);
}

} // namespace

bool
isTumSequence(const std::string& folder)
{
  std::error_code error;
  return fs::exists(fs::path(folder) / color_list, error) ||
         fs::exists(fs::path(folder) / depth_list, error);
}

RgbdSequence
openTumSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const ImageList colors = loadImageList(folder, color_list);
  const ImageList depths = loadImageList(folder, depth_list);
  RgbdSequence sequence;
  sequence.layout = "TUM";
  sequence.camera = tum_camera;
  sequence.depth_scale = tum_depth_scale;
  sequence.is_registered = true;
  for (const auto& [depth, color] :
       matchStamps(depths.stamps, colors.stamps, settings.max_stamp_gap)) {
    RgbdFrame frame;
    frame.color = colors.paths[color];
    frame.depth = depths.paths[depth];
    frame.stamp = depths.stamps[depth];
    sequence.frames.push_back(frame);
  }
  sequence.unmatched = depths.paths.size() - sequence.frames.size();
  if (sequence.frames.empty())
    throw EmptyInputException(folder +
                              ": no colour image was taken near a depth image");
  if (settings.has_poses)
    findPoses(folder, settings.max_stamp_gap, sequence);
  if (sequence.frames.empty())
    throw EmptyInputException(folder + ": " + pose_list + " has no pose near an image");
  if (!settings.has_camera)
    sequence.remarks.push_back(
        "the folder does not tell its camera: took TUM's fx = fy = 525, cx = 319.5, "
        "cy = 239.5; --intrinsics names another");
  return sequence;
}

} // namespace pcl::acmap
