#pragma once

#include <pcl/core/sensor_view.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A cloud for plane detection, with prior knowledge for the methods. Lengths
 * are in metres; all points are finite. */
struct PlaneInput {
  PointCloud<PointXYZ>::Ptr points;

  /** \brief Sensor positions; empty if unknown. */
  std::vector<Eigen::Vector3f> origins;

  /** \brief Sensor of each point; empty if the first one observed all points. */
  std::vector<std::int32_t> views;

  double sigma = 0;   ///< noise across the surface
  double spacing = 0; ///< of the points

  /** \brief Maximum distance of a point from its plane for peers, which have one limit
   * per cloud. */
  double tolerance = 0;

  /** \brief Valid during the lifetime of the input. */
  SensorView
  sensors() const;

  /** \brief Minimum number of points of a plane for the peers: \ref largeCount. */
  std::size_t
  leastSupport() const;
};

/** \brief Tolerance for a known noise: three sigma, but at least 2 mm. */
double
toleranceFor(double sigma);

/** \brief Estimates sigma and spacing of a cloud of finite points, and sets the
 * tolerance. */
PlaneInput
makePlaneInput(const PointCloud<PointXYZ>::Ptr& points,
               std::vector<Eigen::Vector3f> origins,
               std::vector<std::int32_t> views);

/** \brief Minimum number of points of a large plane in a cloud of \a size points: 0.3
 * %. */
std::size_t
largeCount(std::size_t size);

} // namespace pcl::acmap::bench
