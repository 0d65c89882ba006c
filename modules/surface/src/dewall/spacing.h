#pragma once

#include "point_tree.h"
#include "ring_gaps.h"

#include <pcl/surface/impl/dewall_kernel.h>

#include <cstddef>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Spacing of the points in each leaf of the tree, metres. */
struct Spacing {
  LargeVector<double> nearest; ///< to the nearest neighbour of a point
  LargeVector<double> eighth;  ///< to its eighth: 1.41 spacings on a square grid

  std::size_t asked = 0;      ///< points for which the caller's search was called
  std::size_t unanswered = 0; ///< of these, without any neighbour

  /** \brief Median of \ref nearest. */
  double
  median() const;
};

/** \brief Maximum edge length in multiples of the distance to the eighth neighbour. */
constexpr double edge_in_eighths = 2.5;

/** \brief Measures the spacing at two points per leaf and uses the smaller values, so
 * that a single outlier does not determine the spacing of its leaf. The tree must have
 * at least two points.
 * \param[in] neighbours a search that is used instead of the tree; may be empty */
Spacing
measureSpacing(const PointTree& tree, const NeighbourDistances& neighbours);

/** \brief Increases the distances to the eighth neighbour where the rings of a scanner are farther
 * apart than these, so that triangles can connect rings on a surface.
 * \param[in] edge the longest edge elsewhere, metres; 0: by the spacing */
void
reachNextRings(const PointTree& tree,
               const RingGaps& gaps,
               double edge,
               Spacing& spacing);

} // namespace pcl::acmap::ACMAP_DEWALL
