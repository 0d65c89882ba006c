#include "rgbd/camera_file.h"
#include "rgbd/layouts.h"
#include "rgbd/recorded_poses.h"

#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

/** \brief A file of the cameras, in a folder of its own or beside the images; empty if there
 * is none. */
std::string
cameraFile(const fs::path& folder, const std::string& name, const std::string& flat)
{
  const fs::path within = findEntry(folder, {"intrinsic", "intrinsics"});
  fs::path found = within.empty() ? fs::path() : findEntry(within, {name});
  if (found.empty())
    found = findEntry(folder, {flat, name});
  return found.string();
}

std::string
depthCameraFile(const fs::path& folder)
{
  return cameraFile(folder, "intrinsic_depth.txt", "intrinsics_depth.txt");
}

/** \brief Pose of the colour camera in the depth camera's frame, where both are stated in a
 * common frame. */
Eigen::Isometry3d
poseOfColors(const fs::path& folder)
{
  const std::string color = cameraFile(folder, "extrinsic_color.txt", ""),
                    depth = cameraFile(folder, "extrinsic_depth.txt", "");
  if (color.empty() || depth.empty())
    return Eigen::Isometry3d::Identity();
  const auto T_body_color = loadRecordedPose(color),
             T_body_depth = loadRecordedPose(depth);
  if (!T_body_color || !T_body_depth)
    return Eigen::Isometry3d::Identity();
  return T_body_depth->inverse() * *T_body_color;
}

} // namespace

bool
isScannetSequence(const std::string& folder)
{
  std::error_code error;
  const fs::path path(folder);
  return fs::is_directory(findEntry(path, {"depth"}), error) &&
         fs::is_directory(findEntry(path, {"color"}), error) &&
         !depthCameraFile(path).empty();
}

RgbdSequence
openScannetSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const fs::path path(folder);
  RgbdSequence sequence;
  sequence.layout = "ScanNet";
  sequence.is_registered = true;
  NamedFrames named = joinedImages(depthImagesIn(findEntry(path, {"depth"})),
                                   colorImagesIn(findEntry(path, {"color"})),
                                   settings.max_stamp_gap,
                                   folder);
  if (!settings.has_camera)
    sequence.camera = loadMatrixCamera(depthCameraFile(path));
  const std::string color =
      cameraFile(path, "intrinsic_color.txt", "intrinsics_color.txt");
  if (!color.empty())
    sequence.color_camera = {loadMatrixCamera(color), poseOfColors(path), true};
  if (settings.has_poses)
    takePosesOfFolder(path, settings.max_stamp_gap, named, sequence);
  takeFrames(std::move(named), sequence);
  return sequence;
}

} // namespace pcl::acmap
