#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of CylinderHypothesisClustering.
 * \ingroup segmentation */
struct CylinderClusteringReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< not finite
  std::size_t planes = 0;         ///< given, or found in a noisy cloud
  std::size_t replaced_planes = 0;
  std::size_t cylinders = 0;
  std::size_t templates = 0;        ///< different radii
  std::size_t points_on_planes = 0; ///< before; of the described points
  std::size_t points_on_cylinders = 0;

  /** \brief Length of the description of all points by planes, and by planes and
   * cylinders; bits. */
  double bits_before = 0;
  double bits_after = 0;

  double spacing = 0; ///< metres; between neighbouring points
  double sigma = 0;   ///< metres; noise of the points that was measured or set
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const CylinderClusteringReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"planes"}, report.planes);
  visit({"replaced_planes"}, report.replaced_planes);
  visit({"cylinders"}, report.cylinders);
  visit({"templates"}, report.templates);
  visit({"points_on_planes"}, report.points_on_planes);
  visit({"points_on_cylinders"}, report.points_on_cylinders);
  visit({"bits_before", "bits"}, report.bits_before);
  visit({"bits_after", "bits"}, report.bits_after);
  visit({"spacing", "m"}, report.spacing);
  visit({"sigma", "m"}, report.sigma);
}

} // namespace pcl
