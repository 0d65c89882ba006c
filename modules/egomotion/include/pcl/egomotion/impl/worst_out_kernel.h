#pragma once

#include <pcl/core/export.h>
#include <pcl/core/fields.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref leaveWorstOut; see
 * registration::CorrespondenceRejectorWorstOut. */
struct WorstOutSettings {
  double max_distortion = 1.06; ///< maximum D_ij (Eq. 1) of a match that is kept
  double min_distance = 0.05;   ///< metres; shorter distances are set to this
  std::size_t min_matches = 6;  ///< if fewer remain, none is kept
  std::size_t sample = 1000;    ///< matches over which Eq. 1 is averaged, at most 1e6
  bool paper = false;           ///< Eq. 1 as printed; only max_distortion is used then
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const WorstOutSettings& settings, Visitor&& visit)
{
  visit({"max_distortion"}, settings.max_distortion);
  visit({"min_distance", "m"}, settings.min_distance);
  visit({"min_matches"}, settings.min_matches);
  visit({"sample"}, settings.sample);
  visit({"paper"}, settings.paper);
}

/** \brief Result of \ref leaveWorstOut. */
struct WorstOutOutcome {
  std::vector<std::int32_t> kept; ///< indices, ascending; empty: no consistent set
  std::vector<std::int32_t>
      removed; ///< indices, in the order of their removal; all if none is kept
  double distortion = 0; ///< largest D_ij of the kept matches
};

/** \brief Leaving the worst out: removes the match with the largest D_ij (Eq. 1; the
 * first of equal ones) repeatedly until none exceeds the bound. O(n^2) once, O(n) per
 * removal, O(n) memory. Pairs within the minimum distance in both clouds are skipped; a
 * match without any valid pair is removed. If there are more than `sample` matches,
 * evenly chosen ones are cleaned and then used to evaluate Eq. 1 for the others.
 *
 * In paper mode D_ij is the sum over all matches (k, l), near ones and (i, j) itself
 * included, divided by their number. Two distances of 0 have the ratio 1; a distance of
 * 0 in one cloud only has the largest ratio, 1000.
 * \param[in] source, target equally many points, metres; a match with a point that is
 * not finite is removed first */
ACMAP_EXPORT WorstOutOutcome
leaveWorstOut(const std::vector<Eigen::Vector3f>& source,
              const std::vector<Eigen::Vector3f>& target,
              const WorstOutSettings& settings);

} // namespace pcl::acmap
