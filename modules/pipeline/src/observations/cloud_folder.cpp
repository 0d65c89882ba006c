#include "observations/cloud_folder.h"

#include "rgbd/image_folder.h"
#include "rgbd/recorded_poses.h"
#include "rgbd/text_rows.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/cloud_fields.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr const char* kitti_ending = ".bin";

/** \brief The file of poses without times; empty if there is none. */
fs::path
posesIn(const fs::path& folder)
{
  return findEntry(folder, {"poses.txt", "traj.txt"});
}

/** \brief Axes of a camera in those of KITTI's scanner, whose x is ahead and z up. */
Eigen::Isometry3d
cameraOfScanner()
{
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return turn;
}

/** \brief T_camera_scanner of KITTI's calib.txt; nothing if there is none. */
std::optional<Eigen::Isometry3d>
poseOfScanner(const fs::path& folder)
{
  const fs::path found = findEntry(folder, {"calib.txt"});
  if (found.empty())
    return std::nullopt;
  const std::string path = found.string();
  for (const TextRow& row : loadTextRows(path)) {
    if (row.words.size() != 13 || row.words[0].rfind("Tr", 0) != 0)
      continue;
    Eigen::Matrix<double, 3, 4> matrix;
    for (std::size_t i = 0; i < 12; ++i)
      matrix(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) =
          numberOf(path, row, i + 1);
    const Eigen::Matrix3d rotation = matrix.leftCols<3>();
    if (!isRotation(rotation))
      throw InputFileException(path + ": line " + std::to_string(row.line) +
                               ": Tr is no rigid motion");
    Eigen::Isometry3d pose(Eigen::Quaterniond(rotation).normalized());
    pose.translation() = matrix.col(3);
    return pose;
  }
  return std::nullopt;
}

/** \brief Rows of the poses, one per cloud: in their order if there are as many, else by the
 * numbers in the names. */
std::vector<std::size_t>
rowsOfPoses(const std::string& path,
            const std::vector<std::string>& clouds,
            std::size_t poses)
{
  std::vector<std::size_t> rows(clouds.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  if (poses == clouds.size())
    return rows;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const std::optional<double> number = numberInName(clouds[i]);
    if (!number || *number < 0 || *number != std::floor(*number) ||
        *number >= static_cast<double>(poses))
      throw InputFileException(path + ": has " + std::to_string(poses) + " poses for " +
                               std::to_string(clouds.size()) +
                               " clouds, and the name of " + clouds[i] +
                               " does not tell which is its own");
    rows[i] = static_cast<std::size_t>(*number);
  }
  return rows;
}

/** \brief Gives the clouds the poses and times that others recorded of them; those without a
 * pose are left out.
 * \param[in] path of the poses, for messages */
void
takeRecorded(const std::string& path,
             const std::vector<std::optional<Eigen::Isometry3d>>& poses,
             const std::vector<double>& stamps,
             CloudFolder& clouds)
{
  CloudFolder posed = clouds;
  posed.paths.clear();
  posed.is_recorded = true;
  for (std::size_t i = 0; i < clouds.paths.size(); ++i)
    if (poses[i]) {
      posed.rows.push_back(posed.paths.size());
      posed.paths.push_back(clouds.paths[i]);
      posed.trajectory.poses.push_back(*poses[i]);
      posed.trajectory.stamps.push_back(stamps[i]);
    }
  if (posed.paths.empty())
    throw EmptyInputException(path + ": all poses were lost");
  if (const std::size_t lost = clouds.paths.size() - posed.paths.size(); lost > 0)
    posed.remarks.push_back(std::to_string(lost) +
                            " clouds left out: their pose was lost");
  clouds = std::move(posed);
}

/** \brief The poses of KITTI's form for the clouds. */
void
takeKittiPoses(const fs::path& place, const std::string& path, CloudFolder& clouds)
{
  const RecordedPoses recorded = loadRecordedPoses(path);
  const std::vector<std::size_t> rows =
      rowsOfPoses(path, clouds.paths, recorded.poses.size());
  const bool are_scans = endingOf(clouds.paths.front()) == kitti_ending;
  if (are_scans) {
    const auto scanner = poseOfScanner(place);
    if (!scanner)
      clouds.remarks.push_back(path + ": no calib.txt has a row Tr: took the poses as "
                                      "those of the scanner");
    clouds.T_recorded_cloud =
        scanner.value_or(Eigen::Isometry3d::Identity()) * cameraOfScanner();
  }
  const fs::path times = findEntry(place, {times_name});
  const std::vector<double> of_rows =
      times.empty() ? std::vector<double>() : loadTimes(times.string());
  std::vector<std::optional<Eigen::Isometry3d>> poses;
  std::vector<double> stamps;
  for (const std::size_t row : rows) {
    poses.push_back(recorded.poses[row]);
    stamps.push_back(of_rows.size() == recorded.poses.size() ? of_rows[row]
                     : recorded.numbers.empty()              ? static_cast<double>(row)
                                                             : recorded.numbers[row]);
  }
  takeRecorded(path, poses, stamps, clouds);
}

/** \brief The file that has the pose of one cloud, named as it; empty if there is none. */
fs::path
poseFileOf(const fs::path& cloud)
{
  for (const char* ending : {".pose.txt", "_pose.txt", ".pose", ".txt"}) {
    const fs::path file = cloud.parent_path() / (cloud.stem().string() + ending);
    std::error_code error;
    if (file != cloud && fs::is_regular_file(file, error))
      return file;
  }
  return {};
}

/** \brief Takes the poses of a folder that has a file with a 4 x 4 matrix for each cloud.
 * \return false if the first one has no such file */
bool
takeSinglePoses(CloudFolder& clouds)
{
  const fs::path first = poseFileOf(clouds.paths.front());
  if (first.empty())
    return false;
  std::vector<std::optional<Eigen::Isometry3d>> poses;
  std::vector<double> stamps;
  try {
    loadMatrix4(first.string());
  }
  catch (const InputFileException& fault) {
    clouds.remarks.push_back("took no poses of the files beside the clouds: " +
                             std::string(fault.what()));
    return false;
  }
  for (const std::string& cloud : clouds.paths) {
    const fs::path file = poseFileOf(cloud);
    poses.push_back(file.empty() ? std::nullopt : loadRecordedPose(file.string()));
    stamps.push_back(static_cast<double>(stamps.size()));
  }
  takeRecorded(first.string(), poses, stamps, clouds);
  return true;
}

/** \brief The file of the poses in KITTI's form, which stands beside the clouds, beside their
 * folder, or in the folder poses of the data set; empty if there is none. */
fs::path
kittiPosesOf(const fs::path& place)
{
  const fs::path found = posesIn(place);
  if (!found.empty())
    return found;
  const fs::path whole = fs::absolute(place).lexically_normal();
  const fs::path sequence = whole.has_filename() ? whole : whole.parent_path();
  const fs::path set =
      sequence.parent_path().parent_path() / "poses" /
      (sequence.filename().string() + ".txt"); // poses/00.txt of sequences/00
  std::error_code error;
  return endingOf(set) == ".txt" && fs::is_regular_file(set, error) ? set : fs::path();
}

/** \brief Reads a scan of KITTI: x y z intensity, float32, little-endian. */
PointCloudFile
loadKittiScan(const std::string& path)
{
  constexpr std::uintmax_t bytes_per_point = 16;
  constexpr float farthest = 1e5F; // metres
  const auto fail = [&](const std::string& fault) {
    throw InputFileException(path + ": " + fault);
  };
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error)
    fail(error.message());
  if (bytes % bytes_per_point != 0)
    fail("is no scan of KITTI: its size is no multiple of 16 bytes, x y z intensity");
  std::ifstream stream(path, std::ios::binary);
  PointCloudFile file;
  constexpr auto real = PCLPointField::FLOAT32;
  file.cloud =
      layoutWith({}, {{"x", real}, {"y", real}, {"z", real}, {"intensity", real}});
  file.cloud.width = static_cast<uindex_t>(bytes / bytes_per_point);
  file.cloud.height = 1;
  file.cloud.row_step = file.cloud.width * file.cloud.point_step;
  file.cloud.data.resize(rowsOf(file.cloud) * file.cloud.point_step);
  for (std::size_t i = 0; i < rowsOf(file.cloud); ++i) {
    float row[4] = {};
    if (!stream.read(reinterpret_cast<char*>(row), sizeof row))
      fail("cannot be read to its end");
    if (std::max({std::abs(row[0]), std::abs(row[1]), std::abs(row[2])}) > farthest)
      fail("is no scan of KITTI: a point is farther than 100 km");
    const float turned[4] = {-row[1], -row[2], row[0], row[3]};
    std::memcpy(&file.cloud.data[i * file.cloud.point_step], turned, sizeof turned);
  }
  return file;
}

} // namespace

CloudFolder
openCloudFolder(const std::string& folder)
{
  CloudFolder clouds;
  clouds.paths = observationPaths(folder);
  const fs::path place =
      endingOf(clouds.paths.front()) == kitti_ending &&
              fs::path(clouds.paths.front()).parent_path() == fs::path(folder) &&
              findEntry(folder, {trajectory_name}).empty() && posesIn(folder).empty()
          ? fs::path(folder) / ".."
          : fs::path(folder);
  std::vector<std::string> names;
  for (const std::string& path : clouds.paths)
    names.push_back(fs::path(path).filename().string());
  const std::string trajectory = (place / trajectory_name).string();
  const std::string times = (place / times_name).string();
  const fs::path poses = kittiPosesOf(place);
  std::error_code error;
  if (fs::exists(trajectory, error)) {
    clouds.trajectory = loadTrajectory(trajectory);
    clouds.rows = trajectoryRows(trajectory, names, clouds.trajectory.poses.size());
    if (endingOf(names.front()) == kitti_ending)
      clouds.T_recorded_cloud = cameraOfScanner();
    if (!poses.empty())
      clouds.remarks.push_back(trajectory + " has the poses, not " + poses.string());
  }
  else if (!poses.empty())
    takeKittiPoses(place, poses.string(), clouds);
  else if (!takeSinglePoses(clouds) && fs::exists(times, error)) {
    clouds.trajectory.stamps = loadTimes(times);
    clouds.rows = trajectoryRows(times, names, clouds.trajectory.stamps.size());
  }
  return clouds;
}

PointCloudFile
loadObservationFile(const std::string& path, const CloudStatement& stated)
{
  if (endingOf(path) != kitti_ending)
    return loadStatedCloud(path, stated);
  PointCloudFile file = loadKittiScan(path);
  scaleCloud(file, stated.scale);
  return file;
}

} // namespace pcl::acmap
