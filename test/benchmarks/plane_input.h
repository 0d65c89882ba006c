#pragma once

#include <pcl/core/sensor_view.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A cloud in which planes are looked for, with what a finder may know of it:
 * lengths are in metres. All points are finite. */
struct PlaneInput {
  PointCloud<PointXYZ>::Ptr points;

  /** \brief Places of the sensors; empty where they are unknown. */
  std::vector<Eigen::Vector3f> origins;

  /** \brief For each point the sensor that saw it; empty where the first one saw all. */
  std::vector<std::int32_t> views;

  double sigma = 0;   ///< noise across the surface
  double spacing = 0; ///< of the points

  /** \brief How far peers, which have one limit for a whole cloud, let a point lie off its
   * plane. */
  double tolerance = 0;

  /** \brief Valid as long as the input is. */
  SensorView
  sensors() const;

  /** \brief Points of the smallest plane that peers look for: \ref largeCount. */
  std::size_t
  leastSupport() const;
};

/** \brief The tolerance for a known noise: three sigma, or 2 mm if that is more. */
double
toleranceFor(double sigma);

/** \brief Measures sigma and spacing of a cloud of finite points, and has the tolerance follow. */
PlaneInput
makePlaneInput(const PointCloud<PointXYZ>::Ptr& points,
               std::vector<Eigen::Vector3f> origins,
               std::vector<std::int32_t> views);

/** \brief From so many points on a plane in a cloud of \a size counts as large: 0.3 %. */
std::size_t
largeCount(std::size_t size);

} // namespace pcl::acmap::bench
