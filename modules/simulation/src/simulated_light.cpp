#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_light.h>

#include <pcl/core/impl/arguments.h>
#include <pcl/core/trajectory.h>

namespace pcl {

namespace {

void
requireSoundProjector(const SimulatedProjector& projector)
{
  constexpr double longest_side = 8192;
  constexpr double longest_focal_length = 1e6;
  constexpr double farthest = 1e6; // px
  constexpr double widest_blur = 20;
  constexpr double max_power = 1e6;
  using acmap::requireInRange;
  requireInRange("projector width", projector.width, 2, longest_side, "px");
  requireInRange("projector height", projector.height, 2, longest_side, "px");
  requireInRange(
      "projector focal_length", projector.focal_length, 1, longest_focal_length, "px");
  requireInRange("projector center_x", projector.center_x, -farthest, farthest, "px");
  requireInRange("projector center_y", projector.center_y, -farthest, farthest, "px");
  requireInRange(
      "projector aperture_radius", projector.aperture_radius, 0, farthest, "px");
  requireInRange("projector power", projector.power, 0, max_power, "of ambient light");
  requireInRange(
      "projector falloff_distance", projector.falloff_distance, 1e-3, 1e3, "m");
  requireInRange("projector blur", projector.blur, 0, widest_blur, "px");
  if (!isRigid(projector.T_reference_projector))
    throw acmap::BadArgument("T_reference_projector is no rigid motion");
}

} // namespace

void
requireSoundLight(const SimulatedLight& light)
{
  constexpr double brightest = 1e6;
  constexpr double widest_blur = 20;
  constexpr double max_noise = 255;
  using acmap::requireInRange;
  requireSoundProjector(light.projector);
  requireInRange("ambient", light.ambient, 0, brightest, "of full colour");
  requireInRange("exposure", light.exposure, 0, brightest, "(a factor)");
  requireInRange("read_noise", light.read_noise, 0, max_noise, "grey levels");
  requireInRange("shot_noise", light.shot_noise, 0, max_noise, "grey levels");
  requireInRange("blur", light.blur, 0, widest_blur, "px");
}

} // namespace pcl
