#pragma once

#include "outlines/plane_raster.h"

#include <vector>

namespace pcl::acmap::outlines {

/** \brief The lines from sensors to the points that they saw. Nothing is on them. */
class SightRays {
public:
  /** Without rays if the sensors are unknown. */
  SightRays(const PointView& points, const SensorView& sensors);

  bool
  areKnown() const
  {
    return !blocks_.empty();
  }

  /** Calls visit (place) for each ray that crosses a part of a plane from its front, and
   * some that cross it elsewhere, with the place in cells of its raster.
   * \param[in] part of the raster, cells
   * \param[in] min_depth metres between the plane and the point behind it */
  template <typename Visit>
  void
  forEachThrough(const PlaneRaster& raster,
                 const Eigen::AlignedBox2d& part,
                 double min_depth,
                 const Visit& visit) const
  {
    const Eigen::Vector3f normal = raster.normal.cast<float>();
    const auto offset = static_cast<float>(raster.offset);
    const auto limit = static_cast<float>(-min_depth);
    const Eigen::AlignedBox3f wanted = boxOf(raster, part);
    for (const Block& block : blocks_) {
      const Eigen::Vector3f half = block.box.sizes() / 2;
      if (!wanted.intersects(block.ways) ||
          normal.dot(block.box.center()) + offset - normal.cwiseAbs().dot(half) >=
              limit)
        continue;
      for (const Ray& ray : block.rays) {
        const float back = normal.dot(ray.point) + offset;
        const float front = normal.dot(ray.sensor) + offset;
        if (!(back < limit && front > 0))
          continue;
        const double share = static_cast<double>(front) / (front - back);
        const Eigen::Vector3d from = ray.sensor.cast<double>();
        visit(raster.placeOf(from + share * (ray.point.cast<double>() - from)));
      }
    }
  }

private:
  /** Contains a part of a plane. */
  static Eigen::AlignedBox3f
  boxOf(const PlaneRaster& raster, const Eigen::AlignedBox2d& part);

  struct Ray {
    Eigen::Vector3f sensor, point;
  };

  /** Points that follow one another, which are near each other in a consolidated cloud. */
  struct Block {
    static constexpr std::size_t length = 64;

    Eigen::AlignedBox3f box;  ///< of the points that have a sensor
    Eigen::AlignedBox3f ways; ///< of these and their sensors
    std::vector<Ray> rays;
  };

  std::vector<Block> blocks_;
};

} // namespace pcl::acmap::outlines
