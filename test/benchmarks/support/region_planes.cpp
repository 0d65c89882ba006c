#include "region_planes.h"

#include <pcl/core/impl/moments.h>

namespace pcl::acmap::bench {
namespace {

Eigen::Vector4d
planeThrough(const PointCloud<PointXYZ>& points, const Indices& region)
{
  const Eigen::Vector3d origin = points[region.front()].getVector3fMap().cast<double>();
  Moments moments;
  for (const index_t i : region) {
    const Eigen::Vector3d p = points[i].getVector3fMap().cast<double>() - origin;
    moments.addShifted(Moments{1}, p.x(), p.y(), p.z());
  }
  const PlaneFit fit = fitPlane(moments);
  Eigen::Vector4d plane;
  plane << fit.normal, -fit.normal.dot(origin + fit.mean);
  return plane;
}

} // namespace

FoundPlanes
planesOfRegions(const PlaneInput& input, const std::vector<Indices>& regions)
{
  FoundPlanes found;
  found.labels.assign(input.points->size(), -1);
  for (const Indices& region : regions) {
    for (const index_t i : region)
      found.labels[static_cast<std::size_t>(i)] =
          static_cast<std::int32_t>(found.planes.size());
    found.planes.push_back(planeThrough(*input.points, region));
  }
  return found;
}

} // namespace pcl::acmap::bench
