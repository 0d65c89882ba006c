#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of DepthPlaneSegmentation. \ingroup segmentation */
struct DepthPlaneReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< pixels without a measurement
  std::size_t planes = 0;
  std::size_t points_on_planes = 0;
  std::size_t small_regions = 0;  ///< below the minimum area, or of unknown tilt
  std::size_t curved_regions = 0; ///< strips of curved surfaces
  std::size_t merged = 0;         ///< regions that were merged into another plane
  std::size_t regular_planes = 0; ///< made parallel or perpendicular to larger
  double largest_turn = 0;        ///< radians; maximum rotation of these

  NoiseScale::InverseDepth noise; ///< of the view, 1/m
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const DepthPlaneReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"planes"}, report.planes);
  visit({"points_on_planes"}, report.points_on_planes);
  visit({"small_regions"}, report.small_regions);
  visit({"curved_regions"}, report.curved_regions);
  visit({"merged"}, report.merged);
  visit({"regular_planes"}, report.regular_planes);
  visit({"largest_turn", "rad"}, report.largest_turn);
  visit({"noise"}, report.noise);
}

} // namespace pcl
