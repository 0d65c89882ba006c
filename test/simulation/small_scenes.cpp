#include "small_scenes.h"

#include <pcl/core/random.h>
#include <pcl/simulation/standard_scenes.h>

namespace pcl::acmap::test {

TrinocularRig
smallRig(int width)
{
  TrinocularRig rig;
  const double scale = static_cast<double>(width) / rig.width;
  rig.height = rig.height * width / rig.width;
  rig.width = width;
  rig.focal_length *= scale;
  rig.center_x = 0.5 * (rig.width - 1);
  rig.center_y = 0.5 * (rig.height - 1);
  return rig;
}

SimulatedScene
smallScene(const std::string& name, int width)
{
  SimulatedScene scene = standardScene(name);
  const TrinocularRig small = smallRig(width);
  const int pixels = scene.rig.width * scene.rig.height;
  scene.sensor.points = scene.sensor.points *
                        static_cast<std::size_t>(small.width * small.height) /
                        static_cast<std::size_t>(pixels);
  scene.rig = small;
  return scene;
}

SimulatedScene
wallAt(double depth)
{
  constexpr double half = 50.0; // metres
  SimulatedScene scene;
  scene.name = "wall";
  scene.geometry.addRectangle(
      "wall",
      "wall",
      {{-half, half, depth}, {2 * half, 0, 0}, {0, -2 * half, 0}},
      {{100, 150, 200}, 0.0});
  scene.rig = smallRig(160);
  scene.sensor.reach = 2 * depth;
  scene.sensor.points =
      static_cast<std::size_t>(scene.rig.width * scene.rig.height) / 2;
  scene.views = {Eigen::Isometry3d::Identity()};
  return scene;
}

SceneGeometry
clutter(std::uint64_t seed)
{
  Random random(seed);
  const auto vector = [&](double size) {
    return Eigen::Vector3d(random.uniform(-size, size),
                           random.uniform(-size, size),
                           random.uniform(-size, size));
  };
  SceneGeometry scene;
  for (int i = 0; i < 12; ++i) {
    const std::string number = std::to_string(i);
    const Eigen::Vector3d u = vector(1.5);
    const Eigen::Vector3d v = u.cross(vector(1.0)).normalized();
    scene.addRectangle("rectangle " + number, "plane " + number, {vector(4), u, v}, {});
    scene.addCylinder("cylinder " + number,
                      {vector(4), vector(1.5), random.uniform(0.05, 0.5)},
                      {},
                      true);
    const Eigen::Vector3d minimum = vector(4);
    scene.addBox("box " + number, minimum, minimum + vector(0.4).cwiseAbs().eval(), {});
  }
  return scene;
}

} // namespace pcl::acmap::test
