#include "simulated_points.h"

namespace pcl::acmap::bench {

PointCloud<PointXYZ>::Ptr
plainPoints(const SimulatedCloud& cloud)
{
  const auto result = std::make_shared<PointCloud<PointXYZ>>();
  result->reserve(cloud.size());
  for (const Eigen::Vector3f& point : cloud.merged.points)
    result->emplace_back(point.x(), point.y(), point.z());
  return result;
}

PointCloud<PointXYZRGBNormalView>::Ptr
mapPoints(const SimulatedCloud& cloud)
{
  const auto result = std::make_shared<PointCloud<PointXYZRGBNormalView>>();
  result->reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    PointXYZRGBNormalView point;
    point.getVector3fMap() = cloud.merged.points[i];
    point.rgba = cloud.merged.rgb[i];
    point.view = cloud.merged.view[i];
    result->push_back(point);
  }
  return result;
}

} // namespace pcl::acmap::bench
