#include "primitive_scenes.h"

#include "simulated_clouds.h"

#include <pcl/pipeline/plane_mapping.h>

#include <algorithm>
#include <memory>

namespace pcl::acmap::bench {

bool
isInSight(const SimulatedScene& scene, const Eigen::Vector3d& place)
{
  const TrinocularRig& rig = scene.rig;
  return std::any_of(
      scene.views.begin(), scene.views.end(), [&](const Eigen::Isometry3d& view) {
        const Eigen::Vector3d at = view.inverse() * place;
        const double column = rig.focal_length * at.x() / at.z() + rig.center_x,
                     row = rig.focal_length * at.y() / at.z() + rig.center_y;
        return at.z() > 0 && at.z() < scene.sensor.reach && column > 0 &&
               column < rig.width && row > 0 && row < rig.height;
      });
}

MappedPlanes
mapScene(const SimulatedScene& scene, bool searches_cylinders)
{
  const SimulatedCloud cloud = makeSceneCloud(scene);
  const auto file = std::make_shared<PointCloudFile>();
  file->cloud = cloudOf(cloud.merged);
  PlaneMapping mapping;
  mapping.setInputCloud(std::shared_ptr<const PointCloudFile>(file));
  mapping.setViewpoints(cloud.sensorOrigins());
  mapping.setComputeCylinders(searches_cylinders);
  MappedPlanes mapped;
  mapping.compute(mapped);
  return mapped;
}

} // namespace pcl::acmap::bench
