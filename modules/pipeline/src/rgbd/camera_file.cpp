#include "rgbd/camera_file.h"

#include "rgbd/image_folder.h"
#include "rgbd/text_rows.h"

#include <pcl/core/calibration_file.h>

namespace pcl::acmap {

namespace {

constexpr double minimum_focus = 1e-6, maximum_pixels = 1e6;

} // namespace

bool
takeCameraFile(const std::filesystem::path& folder, RgbdSequence& sequence)
{
  const std::filesystem::path file = findEntry(folder,
                                               {"camera_intrinsic.json",
                                                "camera_intrinsics.json",
                                                "intrinsic.json",
                                                "intrinsics.json",
                                                "transforms.json",
                                                "camera.json",
                                                "camera_info.yaml",
                                                "camera.yaml",
                                                "cam_k.txt",
                                                "k.txt",
                                                "intrinsics.txt",
                                                "intrinsic.txt",
                                                "camera_intrinsics.txt",
                                                "camera-intrinsics.txt",
                                                "camera_matrix.csv",
                                                "calibration.txt"});
  if (file.empty())
    return false;
  const CalibratedPinhole camera = loadCameraPinhole(file.string());
  sequence.camera = camera.pinhole;
  sequence.camera_size = {camera.width, camera.height};
  if (camera.depth_scale)
    sequence.depth_scale = *camera.depth_scale;
  return true;
}

Pinhole
loadMatrixCamera(const std::string& path)
{
  const std::vector<TextRow> rows = loadTextRows(path);
  if (rows.size() < 3 || rows[0].words.size() < 3 || rows[1].words.size() < 3)
    throw InputFileException(path +
                             ": is no matrix of a camera: fx 0 cx, 0 fy cy, 0 0 1 "
                             "is needed");
  const Pinhole camera{numberOf(path, rows[0], 0),
                       numberOf(path, rows[1], 1),
                       numberOf(path, rows[0], 2),
                       numberOf(path, rows[1], 2)};
  if (!(camera.fx >= minimum_focus && camera.fy >= minimum_focus &&
        camera.fx <= maximum_pixels && camera.fy <= maximum_pixels))
    throw InputFileException(path + ": has a focal length that is none");
  return camera;
}

} // namespace pcl::acmap
