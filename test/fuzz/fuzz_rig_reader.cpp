#include "checks.h"
#include "files/rig_text.h"

#include <pcl/core/calibration_file.h>

#include <algorithm>
#include <cmath>

using namespace pcl::acmap;

namespace {

void
requireEqual(const pcl::TrinocularRig& a, const pcl::TrinocularRig& b)
{
  test::require(a.width == b.width && a.height == b.height &&
                a.focal_length == b.focal_length && a.center_x == b.center_x &&
                a.center_y == b.center_y &&
                a.baseline_horizontal == b.baseline_horizontal &&
                a.baseline_vertical == b.baseline_vertical &&
                a.disparity_sigma == b.disparity_sigma);
}

void
requireEqual(const pcl::CameraCalibration& a, const pcl::CameraCalibration& b)
{
  test::require(a.is_there == b.is_there && a.focal_x == b.focal_x &&
                a.focal_y == b.focal_y && a.center_x == b.center_x &&
                a.center_y == b.center_y && a.distortion == b.distortion &&
                a.T_reference_camera.matrix() == b.T_reference_camera.matrix());
}

/** A ray that can be computed has unit length and projects to its pixel. */
void
look(const pcl::CameraCalibration& camera)
{
  const Eigen::Vector2d pixel(10, 20);
  const Eigen::Vector3d ray = pcl::pixelRay(camera, pixel);
  if (ray.hasNaN())
    return;
  test::require(std::abs(ray.norm() - 1.0) < 1e-9);
  const double longest = std::max(camera.focal_x, camera.focal_y);
  const double far = (pixel - Eigen::Vector2d(camera.center_x, camera.center_y)).norm();
  test::require((pcl::projectPoint(camera, ray) - pixel).norm() <=
                1e-6 * (longest + far));
}

void
checkRig(const pcl::TrinocularRig& rig)
{
  pcl::requireSoundRig(rig);
  requireEqual(readTrinocularRig(parseYaml("again", rigText(rig))), rig);
}

void
checkCameras(const pcl::RigCalibration& cameras)
{
  pcl::requireSoundCalibration(cameras);
  for (const pcl::CameraCalibration& camera : cameras.cameras)
    if (camera.is_there)
      look(camera);
  pcl::TrinocularRig rig;
  rig.width = cameras.width;
  rig.height = cameras.height;
  if (!cameras.camera(pcl::RigCamera::Horizontal).is_there)
    rig.baseline_horizontal = 0;
  if (!cameras.camera(pcl::RigCamera::Vertical).is_there)
    rig.baseline_vertical = 0;
  const pcl::RigCalibration again =
      readRigCalibration("again", parseYaml("again", rigCalibrationText(rig, cameras)));
  test::require(again.width == cameras.width && again.height == cameras.height);
  for (std::size_t i = 0; i < cameras.cameras.size(); ++i)
    requireEqual(again.cameras[i], cameras.cameras[i]);
}

/** A calibration of any kind is rejected, or gives a rig that can be matched. */
void
checkCalibration(const std::string& text)
{
  const auto calibration =
      test::acceptedBy([&] { return readCalibration("input", text); });
  if (!calibration)
    return;
  pcl::RigImages images;
  images.width = 640;
  images.height = 480;
  const auto rig =
      test::acceptedBy([&] { return rigOf({"input"}, {*calibration}, images); });
  if (!rig)
    return;
  pcl::requireSoundRig(rig->rig);
  if (rig->cameras)
    pcl::requireSoundCalibration(*rig->cameras);
}

} // namespace

/** Bytes are rejected, or give a rig and cameras that can be written and read again. */
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = test::textOfInput(data, size);
  checkCalibration(text);
  const auto map = test::acceptedBy([&] { return parseYaml("input", text); });
  if (!map)
    return 0;
  if (const auto rig = test::acceptedBy([&] { return readTrinocularRig(*map); }))
    checkRig(*rig);
  if (const auto cameras =
          test::acceptedBy([&] { return readRigCalibration("input", *map); }))
    checkCameras(*cameras);
  return 0;
}
