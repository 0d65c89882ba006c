#include "egomotion_input.h"
#include "paper_patterns.h"

#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/standard_scenes.h>
#include <pcl/stereo/active_stereo_grabber.h>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

namespace pcl::acmap::bench {
namespace {

/** The same building with a different grain on nearly textureless surfaces.
 * \param[in] building of rectangles, such as corridors */
SceneGeometry
withGrain(const SceneGeometry& building, double grain)
{
  constexpr double textureless = 2;
  SceneGeometry geometry;
  for (const SimulatedSurface& surface : building.surfaces()) {
    SurfaceLook look = surface.look;
    if (look.texture <= textureless)
      look.texture = grain;
    const auto plane = static_cast<std::size_t>(surface.plane);
    geometry.addRectangle(surface.name,
                          building.planes()[plane].name,
                          std::get<SimulatedRectangle>(surface.shape),
                          look);
  }
  return geometry;
}

} // namespace

EgomotionSequence
driveThrough(const std::string& name, std::optional<double> grain, std::size_t views)
{
  SimulatedScene scene = standardScene(name);
  scene.views.resize(std::min(views, scene.views.size()));
  if (grain)
    scene.geometry = withGrain(scene.geometry, *grain);
  std::ostringstream title;
  title << name << ", grain " << grain.value_or(2);
  EgomotionSequence sequence{title.str(), true, scene.rig, {}, scene.views};
  ActiveStereoGrabber stereo(
      std::make_shared<SimulatedRigGrabber>(scene, drawPatterns()));
  const std::function<ActiveStereoGrabber::CloudCallback> keep =
      [&sequence](const EgomotionCloud::ConstPtr& cloud) {
        sequence.clouds.push_back(cloud);
      };
  stereo.registerCallback(keep);
  stereo.start();
  stereo.wait();
  if (const std::exception_ptr error = stereo.getError())
    std::rethrow_exception(error);
  return sequence;
}

} // namespace pcl::acmap::bench
