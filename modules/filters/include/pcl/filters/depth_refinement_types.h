#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/noise_scale.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of DepthRefinement. \ingroup filters */
struct DepthRefinementReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< pixels without a measurement
  std::size_t on_planes = 0;      ///< moved onto a plane of the view
  std::size_t smoothed = 0;       ///< moved onto the local surface of their neighbours
  std::size_t withdrawn = 0;      ///< removed, without a neighbour at their depth
  std::size_t planes = 0;         ///< of the view
  NoiseScale::InverseDepth noise; ///< of the view, 1/m
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const DepthRefinementReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"on_planes"}, report.on_planes);
  visit({"smoothed"}, report.smoothed);
  visit({"withdrawn"}, report.withdrawn);
  visit({"planes"}, report.planes);
  visit({"noise"}, report.noise);
}

} // namespace pcl
