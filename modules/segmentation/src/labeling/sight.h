#pragma once

#include <pcl/core/plane_patch.h>
#include <pcl/core/sensor_view.h>

#include <cmath>

namespace pcl::acmap::labeling {

/** How a point was measured: where it is, and along which unit direction it may be wrong. */
struct Sight {
  Eigen::Vector3d point;
  Eigen::Vector3d ray; ///< unit, from the sensor; zero where it is unknown
  double range = 0;    ///< metres; 0 where the sensor is unknown

  Sight(const Eigen::Vector3f& point, const Eigen::Vector3f* sensor)
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

/** A point against a plane. */
struct Crossing {
  double off;           ///< metres, of the point from the plane along its normal
  double slant;         ///< |cosine| between ray and normal; 1 where there is no ray
  Eigen::Vector3d foot; ///< where the ray meets the plane; else below the point
  double range;         ///< metres from the sensor to the foot; 0 where it is unknown

  Crossing(const Sight& sight, const PlanePatch& patch)
  {
    const Eigen::Vector3d normal = patch.coefficients.head<3>();
    off = normal.dot(sight.point) + patch.coefficients[3];
    constexpr double least_slant = 0.05; // rays that graze tell nothing of the range
    const double along = normal.dot(sight.ray);
    slant = std::abs(along);
    if (slant > least_slant) {
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
