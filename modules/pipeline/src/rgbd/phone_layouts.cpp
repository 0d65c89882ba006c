#include "rgbd/layouts.h"
#include "rgbd/recorded_poses.h"
#include "rgbd/text_rows.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/yaml_node.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr double max_phone_pixels = 1e6;

/** \brief Rows of a file whose values are separated by commas. */
std::vector<TextRow>
loadCommaRows(const fs::path& path)
{
  std::vector<TextRow> rows;
  for (const TextRow& row : loadTextRows(path.string())) {
    std::string joined;
    for (const std::string& word : row.words)
      joined += word + " ";
    std::replace(joined.begin(), joined.end(), ',', ' ');
    std::istringstream words(joined);
    TextRow separated{row.line, {}};
    for (std::string word; words >> word;)
      separated.words.push_back(word);
    rows.push_back(std::move(separated));
  }
  return rows;
}

/** \brief Camera of the video, 1920 x 1440 pixels unless the principal point says other. */
void
takeStrayCamera(const fs::path& folder, RgbdSequence& sequence)
{
  const fs::path path = findEntry(folder, {"camera_matrix.csv"});
  if (path.empty())
    throw InputFileException((folder / "camera_matrix.csv").string() +
                             ": is missing; --intrinsics states the camera");
  const std::vector<TextRow> rows = loadCommaRows(path);
  if (rows.size() != 3 || std::any_of(rows.begin(), rows.end(), [](const TextRow& row) {
        return row.words.size() != 3;
      }))
    throw InputFileException(path.string() + ": is no matrix of 3 x 3 numbers");
  const std::string name = path.string();
  sequence.camera = {numberOf(name, rows[0], 0),
                     numberOf(name, rows[1], 1),
                     numberOf(name, rows[0], 2),
                     numberOf(name, rows[1], 2)};
  if (!(sequence.camera.fx > 0 && sequence.camera.fy > 0))
    throw InputFileException(name + ": has a focal length that is not above 0");
  // The matrix is that of the video, whose centre is near the principal point.
  constexpr std::int32_t widths[] = {1920, 1280, 640};
  for (const std::int32_t width : widths)
    if (sequence.camera_size.width == 0 &&
        std::abs(2 * sequence.camera.cx - width) < 0.15 * width)
      sequence.camera_size = {width,
                              std::abs(2 * sequence.camera.cy - 0.75 * width) <
                                      std::abs(2 * sequence.camera.cy - 0.5625 * width)
                                  ? width * 3 / 4
                                  : width * 9 / 16};
}

/** \brief Times and poses of odometry.csv: timestamp, frame, x, y, z, qx, qy, qz, qw. */
std::map<double, std::pair<double, Eigen::Isometry3d>>
loadStrayPoses(const fs::path& path)
{
  const std::string name = path.string();
  std::map<double, std::pair<double, Eigen::Isometry3d>> poses;
  const std::vector<TextRow> rows = loadCommaRows(path);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TextRow& row = rows[i];
    if (i == 0 && std::isalpha(static_cast<unsigned char>(row.words[0][0])) != 0)
      continue; // the names of the columns
    if (row.words.size() < 9)
      throw InputFileException(
          name + ": line " + std::to_string(row.line) + ": has " +
          std::to_string(row.words.size()) +
          " numbers, timestamp, frame, x, y, z, qx, qy, qz, qw are "
          "needed");
    std::vector<double> values;
    for (std::size_t word = 0; word < 9; ++word)
      values.push_back(numberOf(name, row, word));
    const Eigen::Quaterniond turn(values[8], values[5], values[6], values[7]);
    if (!(std::abs(turn.norm() - 1) <= text_slack))
      throw InputFileException(name + ": line " + std::to_string(row.line) +
                               ": has a quaternion whose length is not 1");
    Eigen::Isometry3d pose(turn.normalized());
    pose.translation() = Eigen::Vector3d(values[2], values[3], values[4]);
    poses[values[1]] = {values[0], pose};
  }
  return poses;
}

/** \brief Images of the video, if the user took them out of it; else depths alone. */
NamedFrames
strayFrames(const fs::path& folder, double gap, RgbdSequence& sequence)
{
  const std::vector<fs::path> depths = depthImagesIn(findEntry(folder, {"depth"}));
  const fs::path images = findEntry(folder, {"rgb", "color", "images"});
  std::error_code error;
  if (fs::is_directory(images, error))
    return joinedImages(depths, colorImagesIn(images), gap, folder.string());
  const fs::path video = findEntry(folder, {"rgb.mp4", "rgb.mov"});
  sequence.remarks.push_back(
      video.empty()
          ? "the recording has no colours: its surfaces are grey"
          : video.string() + ": the video is not read, surfaces are grey; mkdir " +
                (folder / "rgb").string() + " && ffmpeg -noautorotate -i " +
                video.string() + " -vsync passthrough -start_number 0 " +
                (folder / "rgb").string() + "/%06d.jpg gives its images, which are");
  return depthsAlone(depths);
}

void
takeConfidence(const fs::path& folder, NamedFrames& named, RgbdSequence& sequence)
{
  const fs::path images = findEntry(folder, {"confidence"});
  std::error_code error;
  if (!fs::is_directory(images, error))
    return;
  std::map<double, std::string> numbered;
  for (const fs::path& image : colorImagesIn(images))
    if (const auto number = numberInName(image))
      numbered[*number] = image.string();
  bool is_used = false;
  for (NamedFrame& one : named.frames)
    if (const auto found = numbered.find(one.number.value_or(-1));
        found != numbered.end()) {
      one.frame.confidence = found->second;
      is_used = true;
    }
  if (is_used)
    sequence.remarks.push_back(
        "depths of the lowest confidence are left out; without the "
        "folder confidence, they are taken");
}

/** \brief Poses of Record3D's metadata: lists of qx qy qz qw tx ty tz, of a camera with y up
 * and z backward. */
RecordedPoses
record3dPoses(const YamlNode& metadata)
{
  RecordedPoses recorded;
  const YamlNode* const poses = metadata.find("poses");
  if (!poses)
    return recorded;
  const Eigen::AngleAxisd half_turn(M_PI, Eigen::Vector3d::UnitX());
  for (const YamlNode& row : poses->list(0, std::size_t{1} << 24)) {
    std::vector<double> values;
    for (const YamlNode& value : row.list(7, 7))
      values.push_back(value.number(-1e9, 1e9));
    const Eigen::Quaterniond turn(values[3], values[0], values[1], values[2]);
    if (!(std::abs(turn.norm() - 1) <= text_slack))
      row.fail("is no rotation: the length of its quaternion is not 1");
    Eigen::Isometry3d pose(turn.normalized() * half_turn);
    pose.translation() = Eigen::Vector3d(values[4], values[5], values[6]);
    recorded.poses.emplace_back(pose);
  }
  return recorded;
}

void
takeRecord3dCamera(const YamlNode& metadata, RgbdSequence& sequence)
{
  const std::vector<YamlNode>& matrix = metadata.at("K").list(9, 9); // by columns
  sequence.camera = {matrix[0].number(1e-6, max_phone_pixels),
                     matrix[4].number(1e-6, max_phone_pixels),
                     matrix[6].number(-max_phone_pixels, max_phone_pixels),
                     matrix[7].number(-max_phone_pixels, max_phone_pixels)};
  const YamlNode* const width = metadata.find("w");
  const YamlNode* const height = metadata.find("h");
  if (width && height)
    sequence.camera_size = {
        static_cast<std::int32_t>(width->number(1, max_phone_pixels)),
        static_cast<std::int32_t>(height->number(1, max_phone_pixels))};
}

fs::path
record3dMetadata(const fs::path& folder)
{
  return findEntry(folder, {"metadata.json", "metadata"});
}

/** \brief The folder with Record3D's folders of images: the recording's own or one in it. */
fs::path
record3dImages(const fs::path& folder)
{
  const fs::path within = findEntry(folder, {"exr_rgbd"});
  return within.empty() ? folder : within;
}

} // namespace

bool
isStraySequence(const std::string& folder)
{
  std::error_code error;
  const fs::path path(folder);
  return fs::is_directory(findEntry(path, {"depth"}), error) &&
         !findEntry(path, {"odometry.csv"}).empty();
}

RgbdSequence
openStraySequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const fs::path path(folder);
  RgbdSequence sequence;
  sequence.layout = "StrayScanner";
  sequence.is_registered = true;
  NamedFrames named = strayFrames(path, settings.max_stamp_gap, sequence);
  if (named.frames.empty())
    throw EmptyInputException(folder + ": has no depth image");
  if (!settings.has_camera)
    takeStrayCamera(path, sequence);
  takeConfidence(path, named, sequence);
  if (settings.has_poses) {
    const fs::path odometry = findEntry(path, {"odometry.csv"});
    const auto poses = loadStrayPoses(odometry);
    RecordedPoses recorded;
    for (const auto& [number, pose] : poses) {
      recorded.numbers.push_back(number);
      recorded.poses.emplace_back(pose.second);
    }
    takePoses(recorded, odometry.string(), settings.max_stamp_gap, named, sequence);
    for (NamedFrame& one : named.frames)
      if (const auto found = poses.find(one.number.value_or(-1)); found != poses.end())
        one.frame.stamp = found->second.first;
  }
  takeFrames(std::move(named), sequence);
  return sequence;
}

bool
isRecord3dSequence(const std::string& folder)
{
  std::error_code error;
  const fs::path images = record3dImages(folder);
  return !record3dMetadata(folder).empty() &&
         fs::is_directory(findEntry(images, {"depth"}), error) &&
         fs::is_directory(findEntry(images, {"rgb"}), error);
}

RgbdSequence
openRecord3dSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const fs::path images = record3dImages(folder);
  RgbdSequence sequence;
  sequence.layout = "Record3D";
  sequence.is_registered = true;
  NamedFrames named = joinedImages(depthImagesIn(findEntry(images, {"depth"})),
                                   colorImagesIn(findEntry(images, {"rgb"})),
                                   settings.max_stamp_gap,
                                   folder);
  const std::string path = record3dMetadata(folder).string();
  const YamlNode metadata = loadYaml(path);
  if (!settings.has_camera)
    takeRecord3dCamera(metadata, sequence);
  if (settings.has_poses) {
    const RecordedPoses recorded = record3dPoses(metadata);
    if (recorded.poses.empty())
      goWithoutPoses("poses in " + path, sequence);
    else
      takePoses(recorded, path, settings.max_stamp_gap, named, sequence);
  }
  takeFrames(std::move(named), sequence);
  return sequence;
}

} // namespace pcl::acmap
