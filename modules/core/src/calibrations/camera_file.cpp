#include "calibrations/rig_pair.h"

#include <pcl/core/impl/size_text.h>

#include <algorithm>

namespace pcl {

namespace {

/** \brief The camera of rectified images where it is known, of KITTI's four the left one
 * with colour. */
const CalibratedCamera&
singleCameraOf(const Calibration& calibration)
{
  const auto& cameras = calibration.cameras;
  const auto left =
      std::find_if(cameras.begin(), cameras.end(), [](const CalibratedCamera& camera) {
        return camera.name == "P2";
      });
  return left == cameras.end() ? cameras.front() : *left;
}

} // namespace

CalibratedPinhole
loadCameraPinhole(const std::string& path)
{
  const Calibration calibration = loadCalibration(path);
  const CalibratedCamera& camera = singleCameraOf(calibration);
  // A projection of ROS that equals the camera matrix adds no digits to it.
  const bool is_plain =
      camera.built && camera.built->camera.distortion == std::array<double, 5>{};
  const CalibratedView& view = camera.rectified && !is_plain
                                   ? *camera.rectified
                                   : *(camera.built ? camera.built : camera.rectified);
  CalibratedPinhole found;
  found.pinhole = {view.camera.focal_x,
                   view.camera.focal_y,
                   view.camera.center_x,
                   view.camera.center_y};
  found.width = view.width;
  found.height = view.height;
  found.depth_scale = calibration.depth_scale;
  found.told = calibration.kind;
  if (calibration.cameras.size() > 1)
    found.told += ", camera " + camera.name;
  if (camera.built && !is_plain)
    found.told += ", without its distortion: images are taken as undistorted";
  return found;
}

Pinhole
fittedPinhole(const CalibratedPinhole& camera,
              int width,
              int height,
              const std::string& path)
{
  Pinhole pinhole = camera.pinhole;
  if (camera.width == 0 || (camera.width == width && camera.height == height))
    return pinhole;
  const auto scale = acmap::scaleBetween(camera.width, camera.height, width, height);
  if (!scale)
    throw InputFileException(
        path + ": is for images of " + acmap::sizeText(camera.width, camera.height) +
        " pixels, these have " + acmap::sizeText(width, height) +
        " and so another shape; a calibration of these images is needed");
  pinhole.fx *= *scale;
  pinhole.fy *= *scale;
  pinhole.cx = acmap::scaledCenter(pinhole.cx, *scale);
  pinhole.cy = acmap::scaledCenter(pinhole.cy, *scale);
  return pinhole;
}

} // namespace pcl
