#pragma once

#include <pcl/core/impl/point_view.h>
#include <pcl/core/random.h>
#include <pcl/core/sensor_view.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::test {

/** \brief A parallelogram in space, metres; its normal is along u x v. */
struct Patch {
  Eigen::Vector3d corner, u, v;

  Eigen::Vector3d
  normal() const
  {
    return u.cross(v).normalized();
  }

  /** \brief Signed distance from the plane: positive in front, negative behind. */
  double
  depthOf(const Eigen::Vector3d& place) const
  {
    return (place - corner).dot(normal());
  }

  /** \brief The patch after a rigid motion. */
  Patch
  movedBy(const Eigen::Isometry3d& motion) const
  {
    return {motion * corner, motion.linear() * u, motion.linear() * v};
  }
};

/** \brief Points with the observation of each point. */
struct NoisyCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::int32_t> view;
  std::vector<Eigen::Vector3f> viewpoints;

  PointView
  pointView() const
  {
    return {points.data(), sizeof(Eigen::Vector3f), points.size()};
  }

  /** \brief The sensors of the points. */
  SensorView
  sensorView() const
  {
    return {view.data(), sizeof(std::int32_t), viewpoints};
  }

  /** \brief Adds random points on a patch, with Gaussian noise along its normal.
   * \param[in] density points per square metre
   * \param[in] sigma metres */
  void
  addPatch(const Patch& patch,
           double density,
           double sigma,
           Random& random,
           std::int32_t seen_from = 0);
};

/** \brief A square centred at (0.3, -0.2, 2) with this angle between its normal and the
 * z axis, radians. */
Patch
squarePatch(double side, double inclination);

/** \brief Floor, ceiling and walls of a room of 12 m by 12 m by 3 m, observed from its
 * centre. */
NoisyCloud
makeNoisyRoom(double density, double sigma, std::uint64_t seed);

/** \brief The same points with their views, in another order. */
NoisyCloud
shuffled(const NoisyCloud& cloud, std::uint64_t seed);

} // namespace pcl::acmap::test
