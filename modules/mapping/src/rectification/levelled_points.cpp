#include <pcl/mapping/impl/rectification_kernel.h>

namespace pcl::acmap {

Eigen::Isometry3d
levelOf(const Eigen::Isometry3d& T_map_camera)
{
  return isometryOf(planarPartOf(T_map_camera)).inverse() * T_map_camera;
}

LevelledPoints
levelledPoints(const PointView& points,
               const PointView& normals,
               const Eigen::Isometry3d& T_map_camera,
               const std::vector<float>& weights)
{
  const Eigen::Isometry3f level = levelOf(T_map_camera).cast<float>();
  LevelledPoints seen;
  seen.points.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    seen.points.push_back(level * points[i]);
  seen.normals.reserve(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    seen.normals.push_back(level.linear() * normals[i]);
  seen.weights = weights;
  seen.sensor_height = level.translation().y();
  return seen;
}

} // namespace pcl::acmap
