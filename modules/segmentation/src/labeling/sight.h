#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/sensor_view.h>

#include <cmath>

namespace pcl::acmap::labeling {

// Both constructors are in the loops over all points of a map: as calls they take a third
// of the time.

/** A measured point, and the unit direction along which it may be wrong. */
struct Sight {
  Eigen::Vector3d point;
  Eigen::Vector3d ray; ///< unit, from the sensor; zero where it is unknown
  double range = 0;    ///< metres; 0 where the sensor is unknown

  [[gnu::always_inline]] Sight(const Eigen::Vector3f& point,
                               const Eigen::Vector3f* sensor)
  : point(point.cast<double>())
  , ray(Eigen::Vector3d::Zero())
  {
    if (!sensor)
      return;
    ray = (point - *sensor).cast<double>();
    range = ray.norm();
    if (range > 0)
      ray /= range;
  }
};

/** A point relative to a plane. */
struct Crossing {
  double off;           ///< signed distance of the point from the plane, metres
  double slant;         ///< |cosine| between ray and normal; 1 without a ray
  Eigen::Vector3d foot; ///< intersection of ray and plane, or projection of the point
  double range;         ///< metres from the sensor to the foot; 0 if unknown

  [[gnu::always_inline]] Crossing(const Sight& sight, const PlanePatch& patch)
  {
    const Eigen::Vector3d normal = patch.coefficients.head<3>();
    off = normal.dot(sight.point) + patch.coefficients[3];
    constexpr double min_slant = 0.05; // grazing rays do not determine the range
    const double along = normal.dot(sight.ray);
    slant = std::abs(along);
    if (slant > min_slant) {
      foot = sight.point - off / along * sight.ray;
      range = sight.range - off / along;
      return;
    }
    foot = sight.point - off * normal;
    range = sight.range;
    if (sight.range == 0)
      slant = 1;
  }
};

} // namespace pcl::acmap::labeling
