#pragma once

#include <pcl/core/point_view.h>
#include <pcl/core/random.h>
#include <pcl/core/sensor_view.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl::acmap::test {

/** \brief A parallelogram in space, metres; it looks along u x v. */
struct Patch {
  Eigen::Vector3d corner, u, v;

  Eigen::Vector3d
  normal() const
  {
    return u.cross(v).normalized();
  }

  /** \brief How far a place lies before it; negative behind it. */
  double
  depthOf(const Eigen::Vector3d& place) const
  {
    return (place - corner).dot(normal());
  }

  /** \brief The same patch after a motion. */
  Patch
  movedBy(const Eigen::Isometry3d& motion) const
  {
    return {motion * corner, motion.linear() * u, motion.linear() * v};
  }
};

/** \brief Points with the observation that saw each of them. */
struct NoisyCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::int32_t> view;
  std::vector<Eigen::Vector3f> viewpoints;

  PointView
  pointView() const
  {
    return {points.data(), sizeof(Eigen::Vector3f), points.size()};
  }

  /** \brief The sensors that the field names. */
  SensorView
  sensorView() const
  {
    return {view.data(), sizeof(std::int32_t), viewpoints};
  }

  /** \brief Adds points spread at random over a patch, with normal noise across it.
   * \param[in] density points a square metre
   * \param[in] sigma metres */
  void
  addPatch(const Patch& patch,
           double density,
           double sigma,
           Random& random,
           std::int32_t seen_from = 0);
};

/** \brief A square about (0.3, -0.2, 2) whose normal leaves the z axis by so many
 * radians. */
Patch
squarePatch(double side, double inclination);

/** \brief Floor, ceiling and walls of a room of 12 m by 12 m by 3 m, from its middle. */
NoisyCloud
makeNoisyRoom(double density, double sigma, std::uint64_t seed);

/** \brief The same points in another order, each with its view. */
NoisyCloud
shuffled(const NoisyCloud& cloud, std::uint64_t seed);

} // namespace pcl::acmap::test
