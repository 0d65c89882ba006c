#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <array>
#include <cstddef>

namespace pcl {

/** \brief Two readings of who may support a hypothesis (II-C.2): the point of a supporter is
 * within W_d of another one. \ingroup segmentation */
enum class SupporterReach {
  Members,   ///< of any that was considered before as part of the plane, (ii)
  Hypothesis ///< of that of the hypothesis alone, (i)
};

namespace acmap {

/** \brief The names of \ref SupporterReach in files, in Python and as options. */
inline constexpr std::array<const char*, 2> supporter_reach_names{"members",
                                                                  "hypothesis"};

} // namespace acmap

/** \brief Report of the last run of PlaneHypothesisClustering. \ingroup segmentation */
struct PlaneClusteringReport : Report {
  std::size_t points = 0;
  std::size_t invalid_points = 0; ///< not finite
  std::size_t hypotheses = 0; ///< points with a normal; if noise-driven, off creases
  std::size_t tested_hypotheses = 0; ///< unless noise-driven; of those, not on a plane
  std::size_t reestimations = 0;     ///< unless noise-driven; one per supporter found
  std::size_t planes = 0;
  std::size_t points_on_planes = 0;
  std::size_t small_regions = 0;  ///< too small, or unverifiable without a source
  std::size_t curved_regions = 0; ///< grown, but not planar
  std::size_t points_on_curved = 0;
  std::size_t refuted_regions = 0; ///< not confirmed by the source
  std::size_t merged = 0;          ///< regions that were merged into another plane

  std::size_t turned_planes = 0; ///< to their sensors; the mesh faced away from these
  std::size_t planes_through_sensor = 0; ///< rings of a scanner, removed

  /** \brief Number of boundaries that kept the corners of the evidence, because their
   * straightened edges would cross. */
  std::size_t contour_outlines = 0;

  std::size_t regular_planes = 0; ///< made parallel or perpendicular to larger
  double largest_turn = 0;        ///< radians; maximum rotation of these

  double spacing = 0;        ///< metres; between neighbouring points
  double sigma = 0;          ///< metres; noise of the points along their normals
  double plane_distance = 0; ///< metres; W_t that was used
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const PlaneClusteringReport& report, Visitor&& visit)
{
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"hypotheses"}, report.hypotheses);
  visit({"tested_hypotheses"}, report.tested_hypotheses);
  visit({"reestimations"}, report.reestimations);
  visit({"planes"}, report.planes);
  visit({"points_on_planes"}, report.points_on_planes);
  visit({"small_regions"}, report.small_regions);
  visit({"curved_regions"}, report.curved_regions);
  visit({"points_on_curved"}, report.points_on_curved);
  visit({"refuted_regions"}, report.refuted_regions);
  visit({"merged"}, report.merged);
  visit({"turned_planes"}, report.turned_planes);
  visit({"planes_through_sensor"}, report.planes_through_sensor);
  visit({"contour_outlines"}, report.contour_outlines);
  visit({"regular_planes"}, report.regular_planes);
  visit({"largest_turn", "rad"}, report.largest_turn);
  visit({"spacing", "m"}, report.spacing);
  visit({"sigma", "m"}, report.sigma);
  visit({"plane_distance", "m"}, report.plane_distance);
}

} // namespace pcl
