#include "observations/folder_names.h"
#include "rgbd/foreign_layouts.h"
#include "rgbd/image_sizes.h"
#include "rgbd/layouts.h"
#include "rgbd/text_rows.h"
#include <pcl/core/impl/file_ending.h>

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/folder_entries.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <vector>

namespace pcl {

namespace acmap {

namespace {

namespace fs = std::filesystem;

constexpr double farthest_camera = 1e9; // metres

void
requireRigid(const Eigen::Matrix4d& matrix, const std::string& path)
{
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const Eigen::RowVector4d last_row(0, 0, 0, 1);
  if (!isRotation(rotation) || !matrix.row(3).isApprox(last_row, text_slack))
    throw InputFileException(path + ": is no rigid motion: rotation and translation, "
                                    "0 0 0 1 below them, are needed");
}

/** \brief A known layout. */
struct RgbdLayout {
  bool (*fits)(const std::string& folder);
  RgbdSequence (*open)(const std::string& folder, const RgbdSequenceSettings& settings);
  bool is_general; ///< its names are those of others, too
};

/** \brief The layouts, those with more particular names first. */
constexpr RgbdLayout layouts[] = {
    {&isTumSequence, &openTumSequence, false},
    {&isAssociatedSequence, &openAssociatedSequence, false},
    {&isSevenScenesSequence, &openSevenScenesSequence, false},
    {&isScannetSequence, &openScannetSequence, false},
    {&isReplicaSequence, &openReplicaSequence, false},
    {&isStraySequence, &openStraySequence, false},
    {&isRecord3dSequence, &openRecord3dSequence, false},
    {&isOpen3dSequence, &openOpen3dSequence, true}};

/** \brief Is it no session, map or folder of point clouds? */
bool
holdsOnlyRgbd(const std::string& folder)
{
  const std::set<std::string> names = namesOfFolder(folder);
  return std::none_of(names.begin(), names.end(), [](const std::string& name) {
    const std::string ending = endingOf(name);
    return name == "session.yaml" || name == "map.json" || ending == ".acf" ||
           ending == ".pcd";
  });
}

/** \throws InputFileException that names a folder within, if that is a recording */
void
refuseFolderAbove(const std::string& folder)
{
  std::vector<fs::path> within = folderEntries(folder);
  std::sort(within.begin(), within.end());
  std::error_code error;
  for (const fs::path& entry : within)
    if (fs::is_directory(entry, error) && isRgbdFolder(entry.string()))
      throw InputFileException(folder +
                               ": is no RGB-D folder, but has one: " + entry.string());
}

RgbdSequence
openKnownLayout(const std::string& folder, const RgbdSequenceSettings& settings)
{
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputFileException(folder + ": is no folder");
  for (const RgbdLayout& layout : layouts)
    if (layout.fits(folder) && (!layout.is_general || holdsOnlyRgbd(folder)))
      return layout.open(folder, settings);
  refuseForeignLayout(folder);
  refuseFolderAbove(folder);
  throw InputFileException(
      folder +
      ": is no RGB-D folder; looked for rgb.txt and depth.txt (TUM), associations.txt "
      "(ORB-SLAM), frame-000000.color.jpg or .png with frame-000000.depth.png "
      "(7-Scenes), "
      "results/depth000000.png (Replica), odometry.csv (StrayScanner), metadata.json "
      "(Record3D), and for folders depth and color, image or rgb (ScanNet, Open3D)");
}

} // namespace

} // namespace acmap

RgbdSequence
openRgbdSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  RgbdSequence sequence = acmap::openKnownLayout(folder, settings);
  sequence.folder = folder;
  sequence.has_poses = sequence.has_poses && settings.has_poses;
  acmap::fitCameras(settings.has_camera, sequence);
  return sequence;
}

bool
isRgbdFolder(const std::string& folder)
{
  try {
    return std::any_of(
        std::begin(acmap::layouts),
        std::end(acmap::layouts),
        [&](const acmap::RgbdLayout& layout) { return layout.fits(folder); });
  }
  catch (const InputFileException&) {
    return false; // cannot be listed
  }
}

Eigen::Isometry3d
loadPose(const RgbdFrame& frame)
{
  Eigen::Isometry3d pose;
  if (frame.T_world_camera) {
    pose = *frame.T_world_camera;
  }
  else {
    const std::vector<double> values = acmap::loadSquareMatrix(frame.pose_file, 4);
    const Eigen::Matrix4d matrix =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
    acmap::requireRigid(matrix, frame.pose_file);
    const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
    pose = Eigen::Quaterniond(rotation).normalized();
    pose.translation() = matrix.topRightCorner<3, 1>();
  }
  if (!(pose.translation().cwiseAbs().maxCoeff() < acmap::farthest_camera))
    throw InputFileException(frame.depth + ": its camera is " +
                             acmap::shortNumber(pose.translation().norm()) +
                             " m away from the origin");
  return pose;
}

} // namespace pcl
