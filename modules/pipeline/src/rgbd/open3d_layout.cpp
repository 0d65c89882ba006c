#include "rgbd/camera_file.h"
#include "rgbd/layouts.h"
#include "rgbd/recorded_poses.h"

#include <filesystem>

namespace pcl::acmap {

namespace {

namespace fs = std::filesystem;

constexpr Pinhole primesense = {525.0, 525.0, 319.5, 239.5}; // as Open3D assumes

/** \brief The folder of the colour images; empty if there is none. */
fs::path
colorFolderIn(const fs::path& folder)
{
  std::error_code error;
  for (const char* name : {"color", "image", "rgb", "images"})
    if (const fs::path found = findEntry(folder, {name});
        fs::is_directory(found, error))
      return found;
  return {};
}

fs::path
depthFolderIn(const fs::path& folder)
{
  std::error_code error;
  const fs::path found = findEntry(folder, {"depth", "depths"});
  return fs::is_directory(found, error) ? found : fs::path();
}

/** \brief Takes the camera of the folder, or Open3D's default. */
void
takeCamera(const fs::path& folder, RgbdSequence& sequence)
{
  if (takeCameraFile(folder, sequence))
    return;
  sequence.camera = primesense;
  sequence.camera_size = {640, 480};
  sequence.remarks.push_back(
      "no camera_intrinsic.json tells the camera: took Open3D's fx = fy = 525, cx = "
      "319.5, cy = 239.5; --intrinsics names another");
}

} // namespace

bool
isOpen3dSequence(const std::string& folder)
{
  return !depthFolderIn(folder).empty() && !colorFolderIn(folder).empty();
}

RgbdSequence
openOpen3dSequence(const std::string& folder, const RgbdSequenceSettings& settings)
{
  const fs::path path(folder);
  RgbdSequence sequence;
  sequence.layout = "Open3D";
  sequence.is_registered = true;
  NamedFrames named = joinedImages(depthImagesIn(depthFolderIn(path)),
                                   colorImagesIn(colorFolderIn(path)),
                                   settings.max_stamp_gap,
                                   folder);
  if (!settings.has_camera)
    takeCamera(path, sequence);
  if (settings.has_poses)
    takePosesOfFolder(path, settings.max_stamp_gap, named, sequence);
  takeFrames(std::move(named), sequence);
  return sequence;
}

} // namespace pcl::acmap
