#pragma once

#include <pcl/core/fields.h>
#include <pcl/core/report.h>

#include <cstddef>

namespace pcl {

/** \brief The entropy of a map (Eq. 3) and its terms, in bits. \ingroup mapping */
struct MapEntropyTerms {
  double total = 0; ///< joint + mu (along_x + along_z)
  double joint = 0; ///< H(q_XZ); with directions H(q_XZK)
  double along_x = 0;
  double along_z = 0;

  /** Number of counted points, with any weight; if 0, all terms are 0 and
   * meaningless. */
  std::size_t points = 0;

  /** Number of directions of the XZ plane in which the points are spread: 0 if they are
   * at one position, 1 on a line, otherwise 2. Below 2 the poses are not determined. */
  int dimensions = 0;
};

/** \brief Report of the last run of MapEntropy. \ingroup mapping */
struct MapEntropyReport : Report {
  std::size_t observations = 0;
  std::size_t points = 0;          ///< of all observations
  std::size_t invalid_points = 0;  ///< not finite, skipped
  std::size_t distant_points = 0;  ///< 1e9 m and more from their sensor
  std::size_t directed_points = 0; ///< with the direction of a wall
  std::size_t cells = 0;           ///< representing the points; 0 if computed exactly
  std::size_t bins_x = 0, bins_z = 0, layers = 0; ///< of the grid, with margins
};

/** \brief Calls visit (field, value) for each field; see \ref acmap::Field. */
template <typename Visitor>
void
visitFields(const MapEntropyReport& report, Visitor&& visit)
{
  visit({"observations"}, report.observations);
  visit({"points"}, report.points);
  visit({"invalid_points"}, report.invalid_points);
  visit({"distant_points"}, report.distant_points);
  visit({"directed_points"}, report.directed_points);
  visit({"cells"}, report.cells);
  visit({"bins_x"}, report.bins_x);
  visit({"bins_z"}, report.bins_z);
  visit({"layers"}, report.layers);
}

} // namespace pcl
