#include "shot_check.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/rig_cameras.h>

#include <cmath>

namespace pcl::acmap {

namespace {

void
requireImageOf(const TrinocularRig& rig, const TrinocularFrame& shot, RigCamera camera)
{
  const CameraImage& image = shot.image(camera);
  const auto fail = [&](const std::string& fault) {
    throw acmap::BadArgument("frame " + std::to_string(shot.number) + ": the " +
                             nameOf(camera) + " image " + fault);
  };
  if (image.width == 0 && image.empty())
    fail("is missing");
  if (image.width != rig.width || image.height != rig.height)
    fail("has " + sizeText(image) + " pixels, the rig has " + sizeText(rig) +
         " pixels");
  if (!isWhole(image))
    fail("has not all its values, in 1 or 3 channels");
}

} // namespace

void
requireStereoRig(const TrinocularRig& rig)
{
  requireSoundRig(rig);
  if (countCameras(rig) == 1)
    throw acmap::BadArgument(
        "baseline_horizontal = 0 and baseline_vertical = 0 m are refused: the rig must "
        "have a neighbour");
  constexpr double maximum = 16.0;
  const double ratio = std::abs(rig.baseline_horizontal / rig.baseline_vertical);
  if (rig.baseline_horizontal != 0.0 && rig.baseline_vertical != 0.0 &&
      !(ratio >= 1.0 / maximum && ratio <= maximum))
    throw acmap::BadArgument(
        "baseline_horizontal = " + std::to_string(rig.baseline_horizontal) +
        " m and baseline_vertical = " + std::to_string(rig.baseline_vertical) +
        " m are refused: neither may be longer than 16 times the other");
}

void
requireShotOf(const TrinocularRig& rig, const TrinocularFrame& shot)
{
  for (const RigCamera camera : rig_cameras)
    if (hasCamera(rig, camera))
      requireImageOf(rig, shot, camera);
}

} // namespace pcl::acmap
