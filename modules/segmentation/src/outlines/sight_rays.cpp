#include "outlines/sight_rays.h"

namespace pcl::acmap::outlines {

SightRays::SightRays(const PointView& points, const SensorView& sensors)
{
  if (!sensors.isKnown())
    return;
  blocks_.resize((points.size() + Block::length - 1) / Block::length);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f* const sensor = sensors[i];
    if (!sensor || !points[i].allFinite())
      continue;
    Block& block = blocks_[i / Block::length];
    block.box.extend(points[i]);
    block.ways.extend(points[i]);
    block.ways.extend(*sensor);
    block.rays.push_back({*sensor, points[i]});
  }
}

Eigen::AlignedBox3f
SightRays::boxOf(const PlaneRaster& raster, const Eigen::AlignedBox2d& part)
{
  Eigen::AlignedBox3d box;
  for (int i = 0; i < 4; ++i)
    box.extend(
        raster.pointAt(part.corner(static_cast<Eigen::AlignedBox2d::CornerType>(i))));
  const Eigen::Vector3d rounding = Eigen::Vector3d::Constant(raster.cell);
  return Eigen::AlignedBox3d(box.min() - rounding, box.max() + rounding).cast<float>();
}

} // namespace pcl::acmap::outlines
