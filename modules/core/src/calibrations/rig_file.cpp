#include "calibrations/calibration_kinds.h"
#include "calibrations/rig_pair.h"
#include "files/text_number.h"

#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <algorithm>
#include <cmath>

namespace pcl {

namespace {

using acmap::CameraPair;
using acmap::textOf;

[[noreturn]] void
failRig(const std::string& name, const std::string& fault)
{
  throw InputFileException(name + ": " + fault);
}

/** \brief Refuses a baseline whose unit is probably another one. */
void
requireMetres(const std::string& name, double baseline)
{
  constexpr double longest = 2.0, shortest = 1e-3; // metres
  const double length = std::abs(baseline);
  if (length <= longest && length >= shortest)
    return;
  const double in_metres = length > longest ? baseline / 1000.0 : baseline * 1000.0;
  failRig(name,
          "a baseline of " + acmap::shortNumber(baseline) +
              " m is probably in another unit; --baseline states it in metres, for "
              "example --baseline " +
              acmap::shortNumber(in_metres));
}

std::string
placeText(double baseline)
{
  return (baseline > 0.0 ? "+" : "") + acmap::shortNumber(baseline) + " m";
}

/** \brief Removes the neighbours without images. */
void
leaveOut(const RigImages& images, TrinocularRig& rig)
{
  if (!images.has_vertical)
    rig.baseline_vertical = 0.0;
  if (images.has_horizontal)
    return;
  rig.baseline_horizontal = 0.0;
  rig.center_x_horizontal.reset();
}

/** \brief Replaces the baselines of a `rig.yaml` by the one of its user. */
void
setBaseline(const std::string& name, const RigImages& images, TrinocularRig& rig)
{
  for (double* const baseline : {&rig.baseline_horizontal, &rig.baseline_vertical})
    if (*baseline != 0.0 && !images.baseline)
      requireMetres(name, *baseline);
  if (!images.baseline)
    return;
  if (rig.baseline_horizontal != 0.0 && rig.baseline_vertical != 0.0)
    failRig(name, "has two baselines, so that --baseline does not say which it is");
  (rig.baseline_vertical != 0.0 ? rig.baseline_vertical : rig.baseline_horizontal) =
      *images.baseline;
}

/** \brief Scales a rectified rig to images of another size. */
std::string
fitRig(const std::string& name, const RigImages& images, TrinocularRig& rig)
{
  const std::string from = acmap::sizeText(rig.width, rig.height);
  RigCalibration cameras = calibrationOf(rig);
  const bool is_scaled = acmap::fitToImages(name, images, cameras);
  const CameraCalibration& reference = cameras.camera(RigCamera::Reference);
  rig.width = cameras.width;
  rig.height = cameras.height;
  rig.focal_length = reference.focal_x;
  rig.center_x = reference.center_x;
  rig.center_y = reference.center_y;
  if (rig.center_x_horizontal)
    rig.center_x_horizontal = cameras.camera(RigCamera::Horizontal).center_x;
  return is_scaled ? ", scaled from " + from + " pixels" : "";
}

CalibratedRig
rigOfRigFile(const std::string& name,
             const Calibration& calibration,
             const RigImages& images)
{
  CalibratedRig found;
  found.rig = *calibration.rig;
  leaveOut(images, found.rig);
  setBaseline(name, images, found.rig);
  const std::string scaled = fitRig(name, images, found.rig);
  found.told = calibration.kind;
  for (const auto& [axis, baseline] :
       {std::pair("horizontal", found.rig.baseline_horizontal),
        std::pair("vertical", found.rig.baseline_vertical)})
    if (baseline != 0.0)
      found.told += std::string(", ") + axis + " camera at " + placeText(baseline);
  found.told += scaled;
  return found;
}

/** \brief The only cameras that the images can be of, or those that the user states.
 * \return true for cameras as they are built */
bool
areRaw(const std::string& name, const CameraPair& pair, const RigImages& images)
{
  const bool is_plain = pair.built && acmap::plainRig(*pair.built, false);
  if (images.are_raw.value_or(false) && !pair.built)
    failRig(name,
            "has rectified cameras only: --rectify needs them as they are built, with "
            "their "
            "distortion");
  if (images.are_raw == false && !pair.rectified && !is_plain)
    failRig(
        name,
        "has the cameras as they are built only, with their distortion and rotation: "
        "rectified images need the rectified ones (P1 and P2, or projection_matrix)");
  if (images.are_raw)
    return *images.are_raw;
  if (!pair.built || !pair.rectified)
    return pair.built.has_value();
  if (images.of_camera)
    return true;
  const auto isOfSize = [&](const RigCalibration& cameras) {
    return cameras.width == images.width && cameras.height == images.height;
  };
  if (isOfSize(*pair.built) != isOfSize(*pair.rectified))
    return isOfSize(*pair.built);
  if (acmap::areAlike(*pair.built, *pair.rectified))
    return false;
  failRig(
      name,
      "has the cameras both as they are built and rectified, and the images may be "
      "either: --rectify says that they are as the cameras gave them, --rectified that "
      "they are rectified");
}

/** \brief The rig of the images before rectification: its size, and which neighbour
 * there is. */
TrinocularRig
rigBefore(const RigCalibration& cameras)
{
  const CameraCalibration& reference = cameras.camera(RigCamera::Reference);
  const auto placeOf = [&](RigCamera camera) -> Eigen::Vector3d {
    return cameras.camera(camera).is_there
               ? Eigen::Vector3d(
                     cameras.camera(camera).T_reference_camera.translation())
               : Eigen::Vector3d(Eigen::Vector3d::Zero());
  };
  TrinocularRig rig;
  rig.width = cameras.width;
  rig.height = cameras.height;
  rig.focal_length = reference.focal_x;
  rig.center_x = reference.center_x;
  rig.center_y = reference.center_y;
  rig.baseline_horizontal = placeOf(RigCamera::Horizontal).x();
  rig.baseline_vertical = placeOf(RigCamera::Vertical).y();
  return rig;
}

/** \brief The rig of one hypothesis on the images. */
CalibratedRig
rigOfCameras(const std::string& name, const RigCalibration& cameras, bool is_raw)
{
  CalibratedRig found;
  if (const auto plain = acmap::plainRig(cameras, !is_raw)) {
    found.rig = *plain;
    return found;
  }
  const double rows = acmap::rowResidual(cameras);
  if (constexpr double largest = 1.0; !is_raw && rows > largest)
    failRig(name,
            "the cameras are not of a rectified pair: rows differ by " +
                acmap::shortNumber(rows) + " px");
  found.rig = rigBefore(cameras);
  found.cameras = cameras;
  return found;
}

CalibratedRig
rigOfPair(const std::string& name,
          const Calibration& calibration,
          const CameraPair& pair,
          const RigImages& images)
{
  const bool is_raw = areRaw(name, pair, images);
  RigCalibration cameras = is_raw || !pair.rectified ? *pair.built : *pair.rectified;
  const std::string from = acmap::sizeText(cameras.width, cameras.height);
  const bool is_scaled = acmap::fitToImages(name, images, cameras);
  CalibratedRig found = rigOfCameras(name, cameras, is_raw);
  const bool is_horizontal = found.rig.baseline_horizontal != 0.0;
  const double baseline =
      is_horizontal ? found.rig.baseline_horizontal : found.rig.baseline_vertical;
  if (!images.baseline)
    requireMetres(name, baseline);
  found.told = calibration.kind + " (" + calibration.convention + "), reference " +
               pair.names[0] + ", " + (is_horizontal ? "horizontal " : "vertical ") +
               pair.names[1] + " at " + placeText(baseline) +
               (is_scaled ? ", scaled from " + from + " pixels" : "");
  return found;
}

} // namespace

CalibratedRig
acmap::rigOf(const std::vector<std::string>& names,
             const std::vector<Calibration>& calibrations,
             const RigImages& images)
{
  if (names.empty() || names.size() > 2 || names.size() != calibrations.size())
    throw BadArgument(
        "one or two calibrations are needed, of a rig or its two cameras");
  CalibratedRig found = names.size() == 1 && calibrations.front().rig
                            ? rigOfRigFile(names.front(), calibrations.front(), images)
                            : rigOfPair(names.front(),
                                        calibrations.front(),
                                        pairOf(names, calibrations, images),
                                        images);
  try {
    requireSoundRig(found.rig);
    if (found.cameras)
      requireSoundCalibration(*found.cameras);
  }
  catch (const BadArgumentException& fault) {
    failRig(names.front(), fault.what());
  }
  return found;
}

CalibratedRig
loadRig(const std::vector<std::string>& paths, const RigImages& images)
{
  const std::vector<Calibration> calibrations = acmap::loadCalibrations(paths);
  // Two halves of one calibration have the name of the first.
  const auto count = static_cast<std::ptrdiff_t>(calibrations.size());
  CalibratedRig found =
      acmap::rigOf({paths.begin(), paths.begin() + count}, calibrations, images);
  const Calibration& first = calibrations.front();
  if (!first.rig || paths.size() > 1)
    return found;
  if (!images.are_raw.value_or(images.of_camera && first.has_built_rig)) {
    found.leaves_built_out = first.has_built_rig && !images.are_raw;
    return found;
  }
  found.cameras = loadRigCalibration(paths.front());
  acmap::fitToImages(paths.front(), images, *found.cameras);
  return found;
}

} // namespace pcl
