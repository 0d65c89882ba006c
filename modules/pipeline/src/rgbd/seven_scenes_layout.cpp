#include "rgbd/image_folder.h"
#include "rgbd/layouts.h"
#include "rgbd/recorded_poses.h"
#include "rgbd/text_rows.h"

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

const std::vector<std::string>&
depthEndings()
{
  static const std::vector<std::string> endings = {".depth.png", ".depth.pgm"};
  return endings;
}

bool
isPicture(const std::string& ending)
{
  return std::count(depthEndings().begin(), depthEndings().end(), ending) > 0 ||
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

/** \brief The first of some endings that a frame has, or the first of them. */
std::string
endingAmong(const std::vector<std::string>& known, const std::set<std::string>& endings)
{
  for (const std::string& ending : known)
    if (endings.count(ending) > 0)
      return ending;
  return known.front();
}

/** \brief Paths of the files of a frame; a missing file is reported when it is read. */
RgbdFrame
frameOf(const fs::path& folder,
        const std::string& digits,
        const std::set<std::string>& endings)
{
  const std::string base = (folder / (prefix + digits)).string();
  RgbdFrame frame;
  frame.color = base + endingAmong(colorEndings(), endings);
  frame.depth = base + endingAmong(depthEndings(), endings);
  frame.pose_file = base + pose_ending;
  frame.stamp = std::stod(digits);
  return frame;
}

/** \brief Takes the cameras of _info.txt, which VoxelHashing, 3RScan and early exports of
 * ScanNet have: rows of `name = numbers`.
 * \return false if there is no such file */
bool
takeInfo(const fs::path& folder, RgbdSequence& sequence)
{
  const fs::path file = findEntry(folder, {"_info.txt", "info.txt"});
  if (file.empty())
    return false;
  const std::string path = file.string();
  constexpr std::size_t first_number = 2; // behind the name and the sign
  const auto cameraIn = [&](const TextRow& row) {
    const auto at = [&](std::size_t i) {
      return numberOf(path, row, first_number + i);
    };
    return Pinhole{at(0), at(5), at(2), at(6)};
  };
  for (const TextRow& row : loadTextRows(path)) {
    if (row.words.size() <= first_number)
      continue;
    const std::string& name = row.words.front();
    const auto number = [&](double least, double most) {
      const double value = numberOf(path, row, first_number);
      if (!(value >= least && value <= most))
        throw InputFileException(path + ": line " + std::to_string(row.line) + ": " +
                                 name + " is impossible");
      return value;
    };
    constexpr double longest_side = 32768, finest_scale = 1e9;
    if (name == "m_depthShift")
      sequence.depth_scale = number(1, finest_scale);
    else if (name == "m_depthWidth")
      sequence.camera_size.width = static_cast<std::int32_t>(number(1, longest_side));
    else if (name == "m_depthHeight")
      sequence.camera_size.height = static_cast<std::int32_t>(number(1, longest_side));
    else if (row.words.size() < first_number + 16)
      continue;
    else if (name == "m_calibrationDepthIntrinsic")
      sequence.camera = cameraIn(row);
    else if (name == "m_calibrationColorIntrinsic")
      sequence.color_camera = {cameraIn(row), Eigen::Isometry3d::Identity(), true};
  }
  if (!(sequence.camera.fx > 0 && sequence.camera.fy > 0))
    throw InputFileException(path + ": has no m_calibrationDepthIntrinsic");
  sequence.is_registered = true;
  return true;
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

/** \brief Leaves out the frames whose pose is -inf or nan, as where tracking was lost. */
void
leaveOutLost(RgbdSequence& sequence)
{
  std::vector<RgbdFrame> posed;
  for (RgbdFrame& frame : sequence.frames)
    if (!isLostPose(frame.pose_file))
      posed.push_back(std::move(frame));
  sequence.unposed = sequence.frames.size() - posed.size();
  if (posed.empty())
    throw EmptyInputException(sequence.frames.front().pose_file +
                              ": is a pose that was lost, as all are");
  sequence.frames = std::move(posed);
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
  const bool has_info = !settings.has_camera && takeInfo(folder, sequence);
  if (!settings.has_camera && !has_info)
    sequence.camera = cameraOf(folder, sequence);
  if (!has_info && isKinect(sequence.camera))
    sequence.color_camera = kinectColorCamera();
  bool has_pose = false;
  for (const auto& [digits, endings] : listFrames(folder)) {
    sequence.frames.push_back(frameOf(folder, digits, endings));
    has_pose = has_pose || endings.count(pose_ending) > 0;
  }
  if (settings.has_poses && !has_pose)
    goWithoutPoses("frame-000000.pose.txt", sequence);
  else if (settings.has_poses)
    leaveOutLost(sequence);
  std::stable_sort(
      sequence.frames.begin(),
      sequence.frames.end(),
      [](const RgbdFrame& a, const RgbdFrame& b) { return a.stamp < b.stamp; });
  return sequence;
}

} // namespace pcl::acmap
