#include "rgbd_sequence.h"

#include "input_kind.h"
#include "text_rows.h"
#include "tool.h"

#include <pcl/core/exceptions.h>

#include <cmath>
#include <filesystem>

namespace pcl::acmap {

namespace {

constexpr double farthest = 1e9; // metres

void
requireRigid(const Eigen::Matrix4d& matrix, const std::string& path)
{
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const Eigen::RowVector4d last_row(0, 0, 0, 1);
  if (!isRotation(rotation) || !matrix.row(3).isApprox(last_row, text_slack))
    throw InputFileException(path + ": is no rigid motion: rotation and translation, "
                                    "0 0 0 1 below them, are needed");
}

} // namespace

RgbdSequence
openSequence(const std::string& folder, const SequenceSettings& settings)
{
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error))
    throw InputFileException(folder + ": is no folder");
  if (isTumSequence(folder))
    return openTumSequence(folder, settings);
  if (isSevenScenesSequence(folder))
    return openSevenScenesSequence(folder, settings);
  if (inputKindOf(folder) == InputKind::RgbdFolder)
    throw InputFileException(
        folder +
        ": is no RGB-D folder of a known layout, its images are not listed; "
        "write rgb.txt and depth.txt into it, with a row of number and file for "
        "each image, such as: 0 depth/000000.png");
  throw InputFileException(
      folder + ": is no RGB-D folder; looked for rgb.txt and depth.txt (TUM), and for "
               "frame-000000.color.jpg or .png with frame-000000.depth.png (7-Scenes)");
}

Eigen::Isometry3d
poseOf(const RgbdFrame& frame)
{
  Eigen::Isometry3d pose;
  if (frame.T_world_camera) {
    pose = *frame.T_world_camera;
  }
  else {
    const std::vector<double> values = loadSquareMatrix(frame.pose_file, 4);
    const Eigen::Matrix4d matrix =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values.data());
    requireRigid(matrix, frame.pose_file);
    const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
    pose = Eigen::Quaterniond(rotation).normalized();
    pose.translation() = matrix.topRightCorner<3, 1>();
  }
  if (!(pose.translation().cwiseAbs().maxCoeff() < farthest))
    throw InputFileException(frame.depth + ": its camera is " +
                             shortNumber(pose.translation().norm()) +
                             " m away from the origin");
  return pose;
}

} // namespace pcl::acmap
