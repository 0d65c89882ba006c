#pragma once

#include "mesh_checker.h"

#include <cstdint>

namespace pcl::acmap::bench {

/** \brief Distances from samples of one surface to another, metres. */
struct SurfaceDistance {
  double mean = 0;
  double maximum = 0;
};

/** \brief Distance of a point to the nearest point of a triangle. */
double
distanceToTriangle(const Eigen::Vector3d& point,
                   const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b,
                   const Eigen::Vector3d& c);

/** \brief Samples surface \a from uniformly by area and computes exact distances to
 * surface \a to. */
SurfaceDistance
measureDistance(const test::Points& from_points,
                const test::Triangles& from,
                const test::Points& to_points,
                const test::Triangles& to,
                std::size_t samples,
                std::uint64_t seed);

} // namespace pcl::acmap::bench
