#pragma once

#include <pcl/core/noise_scale.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief What DepthPlaneSegmentation tells about its last run. \ingroup segmentation */
struct DepthPlaneReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< pixels without a measurement
  std::size_t planes = 0;
  std::size_t points_on_planes = 0;
  std::size_t small_regions = 0;  ///< without the area, or of unknown tilt
  std::size_t curved_regions = 0; ///< strips of curved surfaces
  std::size_t merged = 0;         ///< regions that are of the plane of another one
  std::size_t regular_planes = 0; ///< turned to be parallel or upright to larger ones
  double largest_turn = 0;        ///< radians; of these

  NoiseScale::InverseDepth noise; ///< of the view, 1/m
};

} // namespace pcl
