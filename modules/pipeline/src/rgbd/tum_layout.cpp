#include "rgbd/camera_path.h"
#include "rgbd/layouts.h"
#include "rgbd/recorded_poses.h"
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
constexpr const char* eth3d_camera_file = "calibration.txt"; // of ETH3D
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

/** \brief Leaves out the frames without a pose at their time. */
void
findPoses(const fs::path& folder, double gap, RgbdSequence& sequence)
{
  const fs::path found = findEntry(folder, {pose_list, "trajectory.txt"});
  if (found.empty()) {
    goWithoutPoses(pose_list, sequence);
    return;
  }
  const CameraPath camera_path(loadTrajectory(found.string()), gap);
  std::vector<RgbdFrame> posed;
  for (RgbdFrame& frame : sequence.frames) {
    frame.T_world_camera = camera_path.at(frame.stamp);
    if (frame.T_world_camera)
      posed.push_back(frame);
  }
  sequence.unposed = sequence.frames.size() - posed.size();
  sequence.frames = std::move(posed);
  if (sequence.frames.empty())
    throw EmptyInputException(folder.string() + ": " + found.filename().string() +
                              " has no pose near an image");
}

/** \brief Takes the camera of calibration.txt, "fx fy cx cy", or TUM's default. */
void
findCamera(const fs::path& folder, RgbdSequence& sequence)
{
  const fs::path found = findEntry(folder, {eth3d_camera_file});
  if (found.empty()) {
    sequence.camera_size = {640, 480};
    sequence.remarks.push_back(
        "the folder does not tell its camera: took TUM's fx = fy = 525, cx = 319.5, "
        "cy = 239.5; --intrinsics names another");
    return;
  }
  const std::string path = found.string();
  const TextRow row = loadTextRows(path).front();
  if (row.words.size() < 4)
    throw InputFileException(path + ": line " + std::to_string(row.line) +
                             ": fx fy cx cy are needed");
  sequence.camera = {numberOf(path, row, 0),
                     numberOf(path, row, 1),
                     numberOf(path, row, 2),
                     numberOf(path, row, 3)};
  if (!(sequence.camera.fx > 0 && sequence.camera.fy > 0))
    throw InputFileException(path + ": line " + std::to_string(row.line) +
                             ": has a focal length that is not above 0");
}

/** \brief The file that joins colour and depth images, as ORB-SLAM's; empty if there is
 * none. */
fs::path
associationFile(const fs::path& folder)
{
  return findEntry(folder,
                   {"associations.txt",
                    "association.txt",
                    "associate.txt",
                    "associated.txt",
                    "assoc.txt",
                    "rgbd_assoc.txt"});
}

/** \brief Does a path lead to a depth image, by its folder? */
bool
isDepthName(const std::string& name)
{
  return name.find("depth") != name.npos || name.find("Depth") != name.npos;
}

/** \brief Frames of a list whose rows are `stamp rgb/FILE stamp depth/FILE`, or with the
 * depth image first, as of ICL-NUIM. */
std::vector<RgbdFrame>
loadAssociations(const fs::path& folder)
{
  const std::string path = associationFile(folder).string();
  std::vector<RgbdFrame> frames;
  for (const TextRow& row : loadTextRows(path)) {
    if (row.words.size() != 4)
      throw InputFileException(path + ": line " + std::to_string(row.line) + ": has " +
                               std::to_string(row.words.size()) +
                               " words, a stamp and a file of both images are needed");
    const std::size_t depth = isDepthName(row.words[1]) ? 0 : 2;
    RgbdFrame frame;
    frame.stamp = numberOf(path, row, depth);
    for (const std::size_t word : {std::size_t{1}, std::size_t{3}}) {
      if (!isInside(row.words[word]))
        refuseWord(path, row, word, "does not lie in the folder");
      (word == depth + 1 ? frame.depth : frame.color) =
          (folder / row.words[word]).string();
    }
    frames.push_back(std::move(frame));
  }
  std::stable_sort(
      frames.begin(), frames.end(), [](const RgbdFrame& a, const RgbdFrame& b) {
        return a.stamp < b.stamp;
      });
  return frames;
}

/** \brief What the layouts of TUM and of ORB-SLAM have in common. */
RgbdSequence
emptySequence(const std::string& layout)
{
  RgbdSequence sequence;
  sequence.layout = layout;
  sequence.camera = tum_camera;
  sequence.depth_scale = tum_depth_scale;
  sequence.is_registered = true;
  return sequence;
}

} // namespace

bool
isTumSequence(const std::string& folder)
{
  std::error_code error;
  const bool has_colors = fs::exists(fs::path(folder) / color_list, error);
  const bool has_depths = fs::exists(fs::path(folder) / depth_list, error);
  return (has_colors && has_depths) ||
         ((has_colors || has_depths) && !isAssociatedSequence(folder));
}

RgbdSequence
openTumSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const ImageList colors = loadImageList(folder, color_list);
  const ImageList depths = loadImageList(folder, depth_list);
  RgbdSequence sequence = emptySequence("TUM");
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
  if (!settings.has_camera)
    findCamera(folder, sequence);
  return sequence;
}

bool
isAssociatedSequence(const std::string& folder)
{
  return !associationFile(folder).empty();
}

RgbdSequence
openAssociatedSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  RgbdSequence sequence = emptySequence("ORB-SLAM");
  sequence.frames = loadAssociations(folder);
  if (settings.has_poses)
    findPoses(folder, settings.max_stamp_gap, sequence);
  if (!settings.has_camera)
    findCamera(folder, sequence);
  return sequence;
}

} // namespace pcl::acmap
