#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief Report of the last run of BoxFitting. \ingroup segmentation */
struct BoxFittingReport : Report {
  std::size_t planes = 0;
  std::size_t invalid_planes = 0; ///< not finite
  std::size_t edges = 0;          ///< convex edges at right angles between polygons
  std::size_t boxes = 0;
  std::size_t templates = 0; ///< different sizes of boxes
  std::size_t faces = 0;     ///< sides of boxes that are planes

  /** \brief Length of the description of the planes in boxes, and of the boxes; bits. */
  double bits_before = 0;
  double bits_after = 0;

  double sigma = 0; ///< metres; noise of the planes, weighted by their areas
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const BoxFittingReport& report, Visitor&& visit)
{
  visit({"planes"}, report.planes);
  visit({"invalid_planes"}, report.invalid_planes);
  visit({"edges"}, report.edges);
  visit({"boxes"}, report.boxes);
  visit({"templates"}, report.templates);
  visit({"faces"}, report.faces);
  visit({"bits_before", "bits"}, report.bits_before);
  visit({"bits_after", "bits"}, report.bits_after);
  visit({"sigma", "m"}, report.sigma);
}

} // namespace pcl
