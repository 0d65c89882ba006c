#include <pcl/simulation/depth_camera.h>

#include <pcl/core/impl/arguments.h>

#include <cmath>

namespace pcl {

TrinocularRig
kinectRig()
{
  TrinocularRig rig;
  rig.width = 640;
  rig.height = 480;
  rig.focal_length = 575.0;
  rig.center_x = 319.5;
  rig.center_y = 239.5;
  rig.baseline_horizontal = 0.075;
  rig.baseline_vertical = 0.0;
  rig.disparity_sigma = 0.08;
  return rig;
}

void
requireSoundDepthCamera(const DepthCamera& camera, const TrinocularRig& rig)
{
  constexpr int largest_window = 101; // px
  constexpr double farthest = 1e4;    // metres
  using acmap::refuseArgument;
  using acmap::requireInRange;
  requireSoundRig(rig);
  requireInRange("distance of the projector",
                 std::abs(rig.baseline_horizontal),
                 1e-3,
                 10.0,
                 "m (baseline_horizontal of the rig)");
  requireInRange("window", camera.window, 1, largest_window, "px");
  if (camera.window % 2 == 0)
    refuseArgument("window", camera.window, "odd");
  requireInRange("disparity_step", camera.disparity_step, 1e-4, 10.0, "px");
  requireInRange("depth_step", camera.depth_step, 1e-6, 1.0, "m");
  requireInRange("blind_columns", camera.blind_columns, 0, rig.width, "px");
  requireInRange("nearest", camera.nearest, 0.05, farthest, "m");
  requireInRange("farthest", camera.farthest, camera.nearest, farthest, "m");
  requireInRange("fading", camera.fading, camera.nearest, camera.farthest, "m");
}

} // namespace pcl
