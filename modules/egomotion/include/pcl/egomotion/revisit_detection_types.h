#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>
#include <pcl/egomotion/egomotion_types.h>

#include <cstddef>

namespace pcl {

/** \brief Two views of a sequence, made at different times, that see the same place.
 * \ingroup egomotion */
struct Revisit {
  std::size_t earlier = 0, later = 0; ///< numbers of the views
  EgomotionEstimate estimate;         ///< target: the earlier view, source: the later
  std::size_t matches = 0;            ///< keypoints of similar appearance
  std::size_t inliers = 0;            ///< of these, those that agree with the motion
  /** Share of the surface of a view that the other one sees at the same place; the
   * smaller share of both views. */
  double overlap = 0;
  /** Share of the compared surface that would occlude what the other view has seen. */
  double contradicted = 0;
};

/** \brief Report of RevisitDetection on its last run. \ingroup egomotion */
struct RevisitReport : Report {
  std::size_t views = 0, points = 0, invalid_points = 0;
  std::size_t keypoints = 0;  ///< of all views
  std::size_t proposals = 0;  ///< pairs of views that look alike
  std::size_t consistent = 0; ///< of these, those whose keypoints agree in space
  std::size_t verified = 0;   ///< of these, those that the surfaces confirm
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const RevisitReport& report, Visitor&& visit)
{
  visit({"views"}, report.views);
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"keypoints"}, report.keypoints);
  visit({"proposals"}, report.proposals);
  visit({"consistent"}, report.consistent);
  visit({"verified"}, report.verified);
}

} // namespace pcl
