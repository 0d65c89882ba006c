#include "rgbd/layouts.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "frame-";
constexpr const char* camera_file = "camera-intrinsics.txt";
constexpr const char* depth_ending = ".depth.png";
constexpr const char* pose_ending = ".pose.txt";
constexpr std::size_t max_digits = 9;
constexpr Pinhole kinect = {585.0, 585.0, 320.0, 240.0};

const std::vector<std::string>&
colorEndings()
{
  static const std::vector<std::string> endings = {
      ".color.png", ".color.jpg", ".color.jpeg"};
  return endings;
}

bool
isPicture(const std::string& ending)
{
  return ending == depth_ending ||
         std::count(colorEndings().begin(), colorEndings().end(), ending) > 0;
}

/** \brief Extensions of the files of each frame, by the digits of the frame. */
using FrameFiles = std::map<std::string, std::set<std::string>>;

FrameFiles
listFrames(const std::string& folder)
{
  FrameFiles frames;
  for (const fs::path& entry : folderEntries(folder)) {
    const std::string name = entry.filename().string();
    const std::size_t begin = std::string(prefix).size();
    if (name.rfind(prefix, 0) != 0)
      continue;
    const std::size_t end =
        std::min(name.find_first_not_of("0123456789", begin), name.size());
    const std::string ending = name.substr(end);
    if (end > begin && end - begin <= max_digits &&
        (isPicture(ending) || ending == pose_ending))
      frames[name.substr(begin, end - begin)].insert(ending);
  }
  return frames;
}

/** \brief Paths of the files of a frame; a missing file is reported when it is read. */
RgbdFrame
frameOf(const fs::path& folder,
        const std::string& digits,
        const std::set<std::string>& endings)
{
  const std::string base = (folder / (prefix + digits)).string();
  RgbdFrame frame;
  for (const std::string& ending : colorEndings())
    if (frame.color.empty() && endings.count(ending) > 0)
      frame.color = base + ending;
  if (frame.color.empty())
    frame.color = base + colorEndings().front();
  frame.depth = base + depth_ending;
  frame.pose_file = base + pose_ending;
  frame.stamp = std::stod(digits);
  return frame;
}

Pinhole
cameraOf(const fs::path& folder, RgbdSequence& sequence)
{
  const std::string path = (folder / camera_file).string();
  std::error_code error;
  if (fs::exists(path, error))
    return loadPinhole(path);
  sequence.remarks.push_back(std::string("no ") + camera_file +
                             " tells the camera: took 7-Scenes' fx = fy = 585, cx = "
                             "320, cy = 240; --intrinsics names another");
  return kinect;
}

/** \brief Is the camera a Kinect? Other devices use this layout, too. */
bool
isKinect(const Pinhole& camera)
{
  return camera.fx == kinect.fx && camera.fy == kinect.fy && camera.cx == kinect.cx &&
         camera.cy == kinect.cy;
}

} // namespace

bool
isSevenScenesSequence(const std::string& folder)
{
  const FrameFiles frames = listFrames(folder);
  return std::any_of(frames.begin(), frames.end(), [](const auto& frame) {
    return std::any_of(frame.second.begin(), frame.second.end(), &isPicture);
  });
}

RgbdSequence
openSevenScenesSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  RgbdSequence sequence;
  sequence.layout = "7-Scenes";
  if (!settings.has_camera)
    sequence.camera = cameraOf(folder, sequence);
  if (isKinect(sequence.camera))
    sequence.color_camera = kinectColorCamera();
  bool has_pose = false;
  for (const auto& [digits, endings] : listFrames(folder)) {
    sequence.frames.push_back(frameOf(folder, digits, endings));
    has_pose = has_pose || endings.count(pose_ending) > 0;
  }
  if (settings.has_poses && !has_pose)
    throw InputFileException(sequence.frames.front().pose_file +
                             ": is missing, as all poses are; --no-poses does "
                             "without them");
  std::stable_sort(
      sequence.frames.begin(),
      sequence.frames.end(),
      [](const RgbdFrame& a, const RgbdFrame& b) { return a.stamp < b.stamp; });
  return sequence;
}

} // namespace pcl::acmap
