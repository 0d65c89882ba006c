#include "kinect_scenes.h"

#include <pcl/simulation/standard_scenes.h>

#include <cmath>

namespace pcl::acmap::test {

double
inverseStep(const SimulatedScene& scene)
{
  return scene.depth_camera->disparity_step /
         (scene.rig.focal_length * std::abs(scene.rig.baseline_horizontal));
}

SimulatedScene
standardSeenByKinect(const std::string& name)
{
  SimulatedScene scene = standardScene(name);
  useKinect(scene);
  return scene;
}

void
useSmallKinect(SimulatedScene& scene, int width)
{
  useKinect(scene);
  scene.rig.width = width;
  scene.rig.height = width * 3 / 4;
  scene.rig.center_x = 0.5 * (scene.rig.width - 1);
  scene.rig.center_y = 0.5 * (scene.rig.height - 1);
}

SimulatedScene
wallSeenByKinect(double depth, int width)
{
  SimulatedScene scene = wallAt(depth);
  useSmallKinect(scene, width);
  return scene;
}

SimulatedScene
boardBeforeAWall()
{
  SimulatedScene scene = wallSeenByKinect(3.0, 320);
  scene.geometry.addRectangle(
      "board", "board", {{-0.1, 1, 1.5}, {0.2, 0, 0}, {0, -2, 0}}, {});
  return scene;
}

SimulatedScene
slantedWall(double degrees)
{
  SimulatedScene scene = wallSeenByKinect(1.0, 48);
  scene.geometry = SceneGeometry();
  const double angle = degrees * M_PI / 180;
  const Eigen::Vector3d along(4 * std::cos(angle), 0, 4 * std::sin(angle));
  scene.geometry.addRectangle(
      "wall", "wall", {Eigen::Vector3d(0, 2, 1) - along / 2, along, {0, -4, 0}}, {});
  return scene;
}

} // namespace pcl::acmap::test
