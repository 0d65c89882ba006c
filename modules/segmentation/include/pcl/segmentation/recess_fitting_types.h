#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of RecessFitting. \ingroup segmentation */
struct RecessFittingReport : Report {
  std::size_t planes = 0;
  std::size_t invalid_planes = 0; ///< not finite

  /** \brief Polygons less than half a metre behind a parallel wall. */
  std::size_t leaves = 0;
  std::size_t recesses = 0;
  std::size_t templates = 0; ///< different sizes of recesses

  /** \brief Length of the description of leaves and openings, and of the recesses that
   * stand for them; bits. */
  double bits_before = 0;
  double bits_after = 0;

  double sigma = 0; ///< metres; noise of the planes, weighted by their areas
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RecessFittingReport& report, Visitor&& visit)
{
  visit({"planes"}, report.planes);
  visit({"invalid_planes"}, report.invalid_planes);
  visit({"leaves"}, report.leaves);
  visit({"recesses"}, report.recesses);
  visit({"templates"}, report.templates);
  visit({"bits_before", "bits"}, report.bits_before);
  visit({"bits_after", "bits"}, report.bits_after);
  visit({"sigma", "m"}, report.sigma);
}

} // namespace pcl
