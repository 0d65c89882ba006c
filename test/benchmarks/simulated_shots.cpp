#include "simulated_shots.h"
#include "units.h"

#include "paper_patterns.h"

#include <pcl/simulation/simulated_rig_grabber.h>

namespace pcl::acmap::bench {

namespace {

/** Two colours with hardly any grain, on which stereo finds nothing without
 * patterns. */
constexpr SurfaceLook wall_look{{168, 166, 160}, 2.0};
constexpr SurfaceLook box_look{{142, 150, 160}, 2.0};

void
addWall(SimulatedScene& scene)
{
  scene.geometry.addRectangle(
      "wall", "wall", {{-8, 4, 3}, {16, 0, 0}, {0, -8, 0}}, wall_look);
}

/** Pose of a camera that looks at the wall obliquely. */
Eigen::Isometry3d
lookFrom(double x, double y, double yaw, double pitch)
{
  return Eigen::Translation3d(x, y, 0) *
         Eigen::AngleAxisd(yaw * degree, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(pitch * degree, Eigen::Vector3d::UnitX());
}

} // namespace

SimulatedScene
wallWithBox()
{
  SimulatedScene scene;
  scene.name = "wall with a box";
  addWall(scene);
  scene.geometry.addBox("box", {-0.25, -0.25, 1.5}, {0.25, 0.25, 2.0}, box_look);
  scene.views = {lookFrom(0.5, 0.1, -14, 4), lookFrom(-0.7, -0.1, 17, -5)};
  return scene;
}

SimulatedScene
slantedWall()
{
  SimulatedScene scene;
  scene.name = "slanted wall";
  addWall(scene);
  scene.views = {lookFrom(0, 0, 27, 8)};
  return scene;
}

SimulatedShots
takeShots(const SimulatedScene& scene, std::size_t view)
{
  const SimulatedRigGrabber grabber(scene, drawPatterns());
  SimulatedShots taken;
  taken.shots.rig = scene.rig;
  for (const TrinocularFrame::Ptr& frame : grabber.observe(view))
    if (frame->pattern == TrinocularFrame::no_pattern)
      taken.off = frame;
    else
      taken.shots.frames.push_back(frame);
  taken.truth = truthOf(scene, view);
  taken.shots.truth = taken.truth.horizontal;
  return taken;
}

StereoShots
withoutVertical(const StereoShots& shots)
{
  StereoShots two = shots;
  two.rig.baseline_vertical = 0;
  for (TrinocularFrame::ConstPtr& frame : two.frames) {
    TrinocularFrame pair = *frame;
    pair.image(RigCamera::Vertical) = {};
    frame = make_shared<TrinocularFrame>(std::move(pair));
  }
  return two;
}

} // namespace pcl::acmap::bench
