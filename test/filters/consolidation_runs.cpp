#include "consolidation_runs.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

MapCloud::Ptr
toMapCloud(const NoisyCloud& cloud)
{
  auto map = std::make_shared<MapCloud>();
  Random random(99);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    MapPoint point;
    point.getVector3fMap() = cloud.points[i];
    point.rgba = static_cast<std::uint32_t>(random.bits() | 0xff000000U);
    point.view = cloud.view[i];
    map->push_back(point);
  }
  map->is_dense = false;
  return map;
}

Consolidated
consolidate(const NoisyCloud& cloud, double voxel, unsigned threads)
{
  MapConsolidation consolidation;
  consolidation.setInputCloud(toMapCloud(cloud));
  consolidation.setViewpoints(cloud.viewpoints);
  consolidation.setVoxelSize(voxel);
  consolidation.setKeepSources(true);
  consolidation.setNumberOfThreads(threads);
  Consolidated result;
  consolidation.filter(result.cloud);
  result.report = consolidation.getReport();
  result.sources = consolidation.getSourceIndices();
  result.voxel_of_point = consolidation.getVoxelOfPoint();
  return result;
}

double
insetIn(const Patch& patch, const Eigen::Vector3d& place)
{
  const Eigen::Vector3d off = place - patch.corner;
  const double u = off.dot(patch.u.normalized());
  const double v = off.dot(patch.v.normalized());
  return std::min({u, v, patch.u.norm() - u, patch.v.norm() - v});
}

SheetFit
fitOf(
    const MapCloud& cloud, const Patch& patch, double voxel, double reach, double inset)
{
  SheetFit fit;
  std::vector<double> angles;
  for (const MapPoint& point : cloud) {
    const Eigen::Vector3d place = placeOf(point);
    const double depth = patch.depthOf(place);
    const double cosine = normalOf(point).dot(patch.normal());
    if (insetIn(patch, place) < inset || std::abs(depth) > reach || cosine < 0)
      continue;
    ++fit.points;
    fit.mean += depth;
    fit.rms += depth * depth;
    fit.largest = std::max(fit.largest, std::abs(depth));
    if (!std::isnan(cosine))
      angles.push_back(std::acos(std::min(1.0, cosine)));
  }
  if (fit.points == 0 || angles.empty())
    return fit;
  const auto size = static_cast<double>(fit.points);
  fit.mean /= size;
  fit.rms = std::sqrt(fit.rms / size);
  const double area =
      (patch.u.norm() - 2 * inset) * (patch.v.norm() - 2 * inset); // perpendicular
  fit.coverage = size * voxel * voxel / area;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  fit.median_angle = *middle;
  return fit;
}

} // namespace pcl::acmap::test
