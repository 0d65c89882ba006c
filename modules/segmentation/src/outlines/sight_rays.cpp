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
    block.rays.push_back({*sensor, points[i]});
  }
}

} // namespace pcl::acmap::outlines
