#include "rgbd/recorded_poses.h"

#include "rgbd/camera_path.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

using Pose = std::optional<Eigen::Isometry3d>;

[[noreturn]] void
fail(const std::string& path, const TextRow& row, const std::string& fault)
{
  throw InputFileException(path + ": line " + std::to_string(row.line) + ": " + fault);
}

/** \param[in] values 12 or 16, row by row
 * \param[in] row for messages */
Pose
poseOfMatrix(const std::vector<double>& values,
             const std::string& path,
             const TextRow& row)
{
  if (std::none_of(values.begin(), values.begin() + 12, [](double value) {
        return std::isfinite(value);
      }))
    return std::nullopt;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t i = 0; i < values.size(); ++i)
    matrix(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) =
        values[i];
  if (!matrix.allFinite())
    fail(path, row, "has a number that is not finite");
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  if (!isRotation(rotation) ||
      !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), text_slack))
    fail(path, row, "is no rigid motion");
  Eigen::Isometry3d pose(Eigen::Quaterniond(rotation).normalized());
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

/** \param[in] values tx ty tz qx qy qz qw */
Pose
poseOfQuaternion(const std::vector<double>& values,
                 const std::string& path,
                 const TextRow& row)
{
  if (std::none_of(values.begin(), values.end(), [](double value) {
        return std::isfinite(value);
      }))
    return std::nullopt;
  const Eigen::Quaterniond turn(values[6], values[3], values[4], values[5]);
  if (!(std::abs(turn.norm() - 1) <= text_slack))
    fail(path, row, "has a quaternion whose length is not 1");
  Eigen::Isometry3d pose(turn.normalized());
  pose.translation() = Eigen::Vector3d(values[0], values[1], values[2]);
  if (!pose.matrix().allFinite())
    fail(path, row, "has a number that is not finite");
  return pose;
}

std::vector<double>
numbersOf(const std::string& path, const TextRow& row)
{
  std::vector<double> numbers;
  for (std::size_t word = 0; word < row.words.size(); ++word)
    numbers.push_back(anyNumberOf(path, row, word));
  return numbers;
}

/** \brief A pose in four rows of four numbers.
 * \param[in] first of the rows */
Pose
poseOfRows(const std::vector<TextRow>& rows, std::size_t first, const std::string& path)
{
  std::vector<double> values;
  for (std::size_t i = first; i < first + 4; ++i) {
    if (rows[i].words.size() != 4)
      fail(path,
           rows[i],
           "has " + std::to_string(rows[i].words.size()) +
               " numbers, 4 of a matrix are needed");
    for (const double value : numbersOf(path, rows[i]))
      values.push_back(value);
  }
  return poseOfMatrix(values, path, rows[first]);
}

/** \param[in] header is a row of numbers before each matrix? */
RecordedPoses
posesInBlocks(const std::vector<TextRow>& rows, bool header, const std::string& path)
{
  const std::size_t rows_of_pose = header ? 5 : 4;
  if (rows.size() % rows_of_pose != 0)
    throw InputFileException(path + ": has " + std::to_string(rows.size()) + " rows: " +
                             (header
                                  ? "a row of numbers and four of a matrix are needed "
                                    "for each pose"
                                  : "four of a matrix are needed for each pose"));
  RecordedPoses recorded;
  for (std::size_t first = 0; first < rows.size(); first += rows_of_pose) {
    if (header)
      recorded.numbers.push_back(numberOf(path, rows[first], 0));
    recorded.poses.push_back(poseOfRows(rows, first + (header ? 1 : 0), path));
  }
  return recorded;
}

/** \brief Row of a file with one pose a row. */
void
addRow(const std::string& path, const TextRow& row, RecordedPoses& recorded)
{
  std::vector<double> values = numbersOf(path, row);
  const bool has_number =
      values.size() == 8 || values.size() == 13 || values.size() == 17;
  if (has_number) {
    recorded.numbers.push_back(numberOf(path, row, 0));
    values.erase(values.begin());
  }
  if (values.size() == 7 && has_number)
    recorded.poses.push_back(poseOfQuaternion(values, path, row));
  else if (values.size() == 12 || values.size() == 16)
    recorded.poses.push_back(poseOfMatrix(values, path, row));
  else
    fail(
        path,
        row,
        "has " + std::to_string(row.words.size()) +
            " numbers; a pose has 8 (stamp tx ty tz qx qy qz qw), 12 or 16 (a matrix)");
}

void
dropUnposed(NamedFrames& named, RgbdSequence& sequence)
{
  const std::size_t before = named.frames.size();
  named.frames.erase(std::remove_if(named.frames.begin(),
                                    named.frames.end(),
                                    [](const NamedFrame& one) {
                                      return !one.frame.T_world_camera &&
                                             one.frame.pose_file.empty();
                                    }),
                     named.frames.end());
  sequence.unposed += before - named.frames.size();
}

void
takeByTime(const RecordedPoses& recorded, double gap, NamedFrames& named)
{
  Trajectory known;
  for (std::size_t i = 0; i < recorded.poses.size(); ++i)
    if (recorded.poses[i]) {
      known.stamps.push_back(recorded.numbers[i]);
      known.poses.push_back(*recorded.poses[i]);
    }
  const CameraPath path(known, gap);
  for (NamedFrame& one : named.frames)
    one.frame.T_world_camera = path.at(one.frame.stamp);
}

/** \brief Takes the pose whose number is that of the frame: that in the name of its image or,
 * where fewer have one, its place among the images. */
void
takeByNumber(const RecordedPoses& recorded, const std::string& path, NamedFrames& named)
{
  std::map<double, std::size_t> rows;
  for (std::size_t i = 0; i < recorded.poses.size(); ++i)
    rows.emplace(
        recorded.numbers.empty() ? static_cast<double>(i) : recorded.numbers[i], i);
  const auto rowsBy = [&](bool by_name) {
    std::vector<std::optional<std::size_t>> found;
    for (const NamedFrame& one : named.frames) {
      const auto row =
          rows.find(by_name ? one.number.value_or(-1) : static_cast<double>(one.index));
      found.push_back(row == rows.end() ? std::optional<std::size_t>() : row->second);
    }
    return found;
  };
  const auto countOf = [](const auto& found) {
    return std::count_if(
        found.begin(), found.end(), [](const auto& row) { return row.has_value(); });
  };
  const auto named_rows = rowsBy(true), placed_rows = rowsBy(false);
  const bool by_name = countOf(named_rows) >= countOf(placed_rows);
  if (recorded.numbers.empty() && countOf(by_name ? named_rows : placed_rows) <
                                      static_cast<std::ptrdiff_t>(named.frames.size()))
    throw InputFileException(path + ": has " + std::to_string(recorded.poses.size()) +
                             " poses for " + std::to_string(named.depths) +
                             " depth images, and no numbers that tell which belong "
                             "together");
  for (std::size_t i = 0; i < named.frames.size(); ++i)
    if (const auto row = (by_name ? named_rows : placed_rows)[i])
      named.frames[i].frame.T_world_camera = recorded.poses[*row];
}

/** \brief A pose of three or four rows, of a camera with y up and z backward. */
Eigen::Isometry3d
poseOfNerf(const YamlNode& matrix)
{
  Eigen::Matrix<double, 3, 4> rows;
  const std::vector<YamlNode>& lists = matrix.list(3, 4);
  for (Eigen::Index row = 0; row < 3; ++row) {
    const std::vector<YamlNode>& values =
        lists[static_cast<std::size_t>(row)].list(4, 4);
    for (Eigen::Index column = 0; column < 4; ++column)
      rows(row, column) = values[static_cast<std::size_t>(column)].number(-1e9, 1e9);
  }
  const Eigen::Matrix3d rotation = rows.leftCols<3>();
  if (!isRotation(rotation))
    matrix.fail("is no rigid motion");
  const Eigen::AngleAxisd half_turn(M_PI, Eigen::Vector3d::UnitX());
  Eigen::Isometry3d pose(Eigen::Quaterniond(rotation).normalized() * half_turn);
  pose.translation() = rows.col(3);
  return pose;
}

/** \brief Files of poses, one per frame, by the numbers in their names. */
void
takePoseFiles(const fs::path& folder, NamedFrames& named, RgbdSequence& sequence)
{
  std::map<double, std::string> numbered;
  for (const fs::path& entry : folderEntries(folder.string()))
    if (const auto number = numberInName(entry); endingOf(entry) == ".txt" && number)
      numbered[*number] = entry.string();
  for (NamedFrame& one : named.frames) {
    const auto found =
        numbered.find(one.number.value_or(static_cast<double>(one.index)));
    if (found != numbered.end())
      one.frame.T_world_camera = loadRecordedPose(found->second);
  }
  dropUnposed(named, sequence);
  if (named.frames.empty())
    throw EmptyInputException(folder.string() + ": has no pose of an image");
}

} // namespace

RecordedPoses
loadRecordedPoses(const std::string& path)
{
  return posesOfRows(loadTextRows(path), path);
}

RecordedPoses
posesOfRows(const std::vector<TextRow>& rows, const std::string& path)
{
  const std::size_t words = rows.front().words.size();
  if (words <= 3 || endingOf(path) == ".log")
    return posesInBlocks(rows, true, path);
  if (words == 4)
    return posesInBlocks(rows, false, path);
  RecordedPoses recorded;
  for (const TextRow& row : rows) {
    if (row.words.size() != words)
      fail(path,
           row,
           "has " + std::to_string(row.words.size()) + " numbers, the first row has " +
               std::to_string(words));
    addRow(path, row, recorded);
  }
  return recorded;
}

RecordedPoses
posesOfFrames(const YamlNode& transforms)
{
  std::map<double, Pose> poses;
  for (const YamlNode& frame : transforms.at("frames").list(1, std::size_t{1} << 24)) {
    const YamlNode& image = frame.at("file_path");
    const auto number = numberInName(image.text());
    if (!number)
      image.fail("has no number in the name of its image");
    poses[*number] = poseOfNerf(frame.at("transform_matrix"));
  }
  RecordedPoses recorded;
  for (const auto& [number, pose] : poses) {
    recorded.numbers.push_back(number);
    recorded.poses.push_back(pose);
  }
  return recorded;
}

std::optional<Eigen::Isometry3d>
loadRecordedPose(const std::string& path)
{
  const std::vector<TextRow> rows = loadTextRows(path);
  if (rows.size() != 4)
    throw InputFileException(path + ": has " + std::to_string(rows.size()) +
                             " rows, 4 of a matrix are needed");
  return poseOfRows(rows, 0, path);
}

bool
isLostPose(const std::string& path)
{
  try {
    return !loadRecordedPose(path);
  }
  catch (const InputFileException&) {
    return false;
  }
}

Eigen::Matrix4d
loadMatrix4(const std::string& path)
{
  const std::vector<double> values = loadSquareMatrix(path, 4);
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
}

void
takePoses(const RecordedPoses& recorded,
          const std::string& path,
          double gap,
          NamedFrames& named,
          RgbdSequence& sequence)
{
  const std::size_t count = recorded.poses.size();
  if (named.are_times && !recorded.numbers.empty())
    takeByTime(recorded, gap, named);
  else if (count == named.depths || count == named.frames.size())
    for (std::size_t i = 0; i < named.frames.size(); ++i)
      named.frames[i].frame.T_world_camera =
          recorded.poses[count == named.depths ? named.frames[i].index : i];
  else
    takeByNumber(recorded, path, named);
  dropUnposed(named, sequence);
  if (named.frames.empty())
    throw EmptyInputException(path + ": has no pose of an image");
}

void
takePosesOfFolder(const fs::path& folder,
                  double gap,
                  NamedFrames& named,
                  RgbdSequence& sequence)
{
  fs::path file = findEntry(folder,
                            {"trajectory.log",
                             "groundtruth.txt",
                             "trajectory.txt",
                             "traj.txt",
                             "poses.txt",
                             "pose.txt"});
  if (file.empty())
    file = findEntry(folder / "scene", {"trajectory.log"});
  const fs::path frames = findEntry(folder, {"transforms.json"});
  const fs::path files = findEntry(folder, {"pose", "poses"});
  std::error_code error;
  if (!file.empty())
    takePoses(loadRecordedPoses(file.string()), file.string(), gap, named, sequence);
  else if (!frames.empty())
    takePoses(posesOfFrames(loadYaml(frames.string())),
              frames.string(),
              gap,
              named,
              sequence);
  else if (fs::is_directory(files, error))
    takePoseFiles(files, named, sequence);
  else
    goWithoutPoses("trajectory.log (Open3D), groundtruth.txt or trajectory.txt (TUM), "
                   "poses.txt (KITTI), transforms.json, folder pose",
                   sequence);
}

void
goWithoutPoses(const std::string& wanted, RgbdSequence& sequence)
{
  sequence.has_poses = false;
  sequence.remarks.push_back("the recording has no poses (looked for " + wanted +
                             "): pcl_visual_egomotion or pcl_compact_mapping "
                             "finds them");
}

void
takeFrames(NamedFrames named, RgbdSequence& sequence)
{
  sequence.unmatched = named.unmatched;
  if (!named.remark.empty())
    sequence.remarks.push_back(named.remark);
  for (NamedFrame& one : named.frames)
    sequence.frames.push_back(std::move(one.frame));
  std::stable_sort(
      sequence.frames.begin(),
      sequence.frames.end(),
      [](const RgbdFrame& a, const RgbdFrame& b) { return a.stamp < b.stamp; });
}

} // namespace pcl::acmap
