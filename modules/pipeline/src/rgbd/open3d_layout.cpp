#include "observations/file_ending.h"
#include "rgbd/layouts.h"
#include "rgbd/text_rows.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/impl/yaml_node.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr Pinhole primesense = {525.0, 525.0, 319.5, 239.5}; // as Open3D assumes

/** \brief The folder of the colour images; empty if there is none. */
fs::path
colorFolderIn(const fs::path& folder)
{
  std::error_code error;
  for (const char* name : {"color", "image", "rgb"})
    if (fs::is_directory(folder / name, error))
      return folder / name;
  return {};
}

/** \brief Are names in order, with their numbers by value? 9.png is before 10.png. */
bool
isBefore(const std::string& a, const std::string& b)
{
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[k])) {
      if (a[i] != b[k])
        return a[i] < b[k];
      ++i;
      ++k;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0')
        ++at;
      const std::size_t begin = at;
      while (at < text.size() && isDigit(text[at]))
        ++at;
      return text.substr(begin, at - begin);
    };
    const std::string left = number(a, i), right = number(b, k);
    if (left.size() != right.size() || left != right)
      return std::pair(left.size(), left) < std::pair(right.size(), right);
  }
  return std::pair(a.size() - i, a) < std::pair(b.size() - k, b);
}

std::vector<fs::path>
imagesIn(const fs::path& folder)
{
  std::vector<fs::path> images;
  for (const fs::path& entry : folderEntries(folder.string())) {
    const std::string ending = endingOf(entry);
    if (ending == ".png" || ending == ".jpg" || ending == ".jpeg")
      images.push_back(entry);
  }
  std::sort(images.begin(), images.end(), [](const fs::path& a, const fs::path& b) {
    return isBefore(a.filename().string(), b.filename().string());
  });
  return images;
}

/** \brief Joins images of the same name, or in their order if names differ.
 * \throws InputFileException if neither is possible */
std::vector<RgbdFrame>
framesOf(const std::vector<fs::path>& depths,
         const std::vector<fs::path>& colors,
         const fs::path& folder,
         std::size_t& unmatched)
{
  std::map<std::string, fs::path> named;
  for (const fs::path& color : colors)
    named[color.stem().string()] = color;
  const bool have_names =
      std::any_of(depths.begin(), depths.end(), [&](const fs::path& depth) {
        return named.count(depth.stem().string()) > 0;
      });
  if (!have_names && depths.size() != colors.size())
    throw InputFileException(folder.string() + ": has " +
                             std::to_string(depths.size()) + " depth images and " +
                             std::to_string(colors.size()) +
                             " colour images, whose names differ");
  std::vector<RgbdFrame> frames;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto color = named.find(depths[i].stem().string());
    if (have_names && color == named.end()) {
      ++unmatched;
      continue;
    }
    RgbdFrame frame;
    frame.depth = depths[i].string();
    frame.color = (have_names ? color->second : colors[i]).string();
    frame.stamp = static_cast<double>(i);
    frames.push_back(std::move(frame));
  }
  return frames;
}

/** \brief Reads Open3D's PinholeCameraIntrinsic, whose matrix is stored by columns. */
Pinhole
loadIntrinsic(const std::string& path)
{
  constexpr double minimum = 1e-6, maximum = 1e6;
  const YamlNode file = loadYaml(path); // JSON is YAML
  const std::vector<YamlNode>& matrix = file.at("intrinsic_matrix").list(9, 9);
  return {matrix[0].number(minimum, maximum),
          matrix[4].number(minimum, maximum),
          matrix[6].number(-maximum, maximum),
          matrix[7].number(-maximum, maximum)};
}

/** \brief The file of the camera or of the poses; empty if there is none. */
std::string
findFile(const fs::path& folder, const std::vector<const char*>& names)
{
  std::error_code error;
  for (const char* name : names)
    if (fs::is_regular_file(folder / name, error))
      return (folder / name).string();
  return {};
}

/** \brief A pose of a trajectory of Redwood's form. */
struct LoggedPose {
  double frame; ///< the first number before its matrix
  Eigen::Isometry3d T_world_camera;
};

std::vector<LoggedPose>
loadPoseLog(const std::string& path)
{
  constexpr std::size_t rows_of_pose = 5;
  const std::vector<TextRow> rows = loadTextRows(path);
  if (rows.size() % rows_of_pose != 0)
    throw InputFileException(path + ": has " + std::to_string(rows.size()) +
                             " rows: a row of numbers and four of a matrix are needed "
                             "for each pose");
  std::vector<LoggedPose> poses;
  for (std::size_t first = 0; first < rows.size(); first += rows_of_pose) {
    Eigen::Matrix4d matrix;
    for (std::size_t row = 0; row < 4; ++row) {
      const TextRow& text = rows[first + 1 + row];
      if (text.words.size() != 4)
        throw InputFileException(path + ": line " + std::to_string(text.line) +
                                 ": has " + std::to_string(text.words.size()) +
                                 " numbers, 4 of a matrix are needed");
      for (std::size_t column = 0; column < 4; ++column)
        matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            numberOf(path, text, column);
    }
    const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
    if (!isRotation(rotation) ||
        !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), text_slack))
      throw InputFileException(path + ": line " + std::to_string(rows[first + 1].line) +
                               ": is no rigid motion");
    Eigen::Isometry3d pose(Eigen::Quaterniond(rotation).normalized());
    pose.translation() = matrix.topRightCorner<3, 1>();
    poses.push_back({numberOf(path, rows[first], 0), pose});
  }
  return poses;
}

/** \brief Gives the frames their poses: in their order if there are as many, else by the
 * numbers before the matrices. */
void
takePoses(const std::vector<LoggedPose>& poses, RgbdSequence& sequence)
{
  if (poses.size() == sequence.frames.size()) {
    for (std::size_t i = 0; i < poses.size(); ++i)
      sequence.frames[i].T_world_camera = poses[i].T_world_camera;
    return;
  }
  std::map<double, Eigen::Isometry3d> numbered;
  for (const LoggedPose& pose : poses)
    numbered.emplace(pose.frame, pose.T_world_camera);
  std::vector<RgbdFrame> posed;
  for (RgbdFrame& frame : sequence.frames)
    if (const auto pose = numbered.find(frame.stamp); pose != numbered.end()) {
      frame.T_world_camera = pose->second;
      posed.push_back(std::move(frame));
    }
  sequence.unposed = sequence.frames.size() - posed.size();
  sequence.frames = std::move(posed);
}

} // namespace

bool
isOpen3dSequence(const std::string& folder)
{
  std::error_code error;
  return fs::is_directory(fs::path(folder) / "depth", error) &&
         !colorFolderIn(folder).empty();
}

RgbdSequence
openOpen3dSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const fs::path path(folder);
  RgbdSequence sequence;
  sequence.layout = "Open3D";
  sequence.is_registered = true;
  sequence.camera = primesense;
  sequence.frames = framesOf(imagesIn(path / "depth"),
                             imagesIn(colorFolderIn(path)),
                             path,
                             sequence.unmatched);
  if (sequence.frames.empty())
    throw EmptyInputException(folder + ": has no depth image with a colour image");
  const std::string camera = findFile(
      path, {"camera_intrinsic.json", "camera_intrinsics.json", "intrinsic.json"});
  if (!settings.has_camera && !camera.empty())
    sequence.camera = loadIntrinsic(camera);
  else if (!settings.has_camera)
    sequence.remarks.push_back(
        "no camera_intrinsic.json tells the camera: took Open3D's fx = fy = 525, cx = "
        "319.5, cy = 239.5; --intrinsics names another");
  if (!settings.has_poses)
    return sequence;
  const std::string log = findFile(path, {"trajectory.log", "scene/trajectory.log"});
  if (log.empty())
    throw InputFileException((path / "trajectory.log").string() +
                             ": is missing; --no-poses does without it");
  takePoses(loadPoseLog(log), sequence);
  if (sequence.frames.empty())
    throw EmptyInputException(log + ": has no pose of an image");
  return sequence;
}

} // namespace pcl::acmap
