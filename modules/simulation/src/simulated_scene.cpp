#include <pcl/core/exceptions.h>
#include <pcl/simulation/simulated_scene.h>

#include <pcl/core/impl/arguments.h>

#include <algorithm>

namespace pcl {

double
RangeSensor::sigma(double depth) const
{
  return std::clamp(noise_growth * depth * depth, min_noise, max_noise);
}

void
useKinect(SimulatedScene& scene)
{
  scene.rig = kinectRig();
  scene.depth_camera = DepthCamera();
}

Trajectory
trajectoryOf(const SimulatedScene& scene, std::size_t views)
{
  constexpr double seconds_between = 1.0;
  acmap::requireInRange("number of observations",
                        static_cast<double>(views),
                        1.0,
                        static_cast<double>(scene.views.size()),
                        "(the views of the scene)");
  const Eigen::Isometry3d T_map_scene = scene.views.front().inverse();
  Trajectory trajectory;
  for (std::size_t i = 0; i < views; ++i) {
    trajectory.stamps.push_back(static_cast<double>(i) * seconds_between);
    trajectory.poses.push_back(i == 0 ? Eigen::Isometry3d::Identity()
                                      : T_map_scene * scene.views[i]);
  }
  return trajectory;
}

std::vector<TruthPlane>
planesInMap(const SimulatedScene& scene)
{
  if (scene.views.empty())
    throw acmap::BadArgument("a scene without views has no map frame");
  const Eigen::Isometry3d T_map_scene = scene.views.front().inverse();
  std::vector<TruthPlane> planes;
  for (const TruthPlane& plane : scene.geometry.planes())
    planes.push_back(transformPlane(plane, T_map_scene));
  return planes;
}

} // namespace pcl
