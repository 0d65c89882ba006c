#pragma once

#include "point_tree.h"

#include <pcl/surface/dewall_kernel.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap::dewall {

/** \brief How far apart the points of each leaf of the tree stand, metres. */
struct Spacing {
  std::vector<double> nearest; ///< for each, from a point to its nearest neighbour
  std::vector<double> eighth;  ///< and to its eighth: 1.41 spacings on a square grid

  std::size_t asked = 0;      ///< points that the caller's search was asked about
  std::size_t unanswered = 0; ///< of these, where it found none but the point

  /** \brief Median of \ref nearest. */
  double
  median() const;
};

/** \brief Looks at two points a leaf and takes the lesser values, so that one outlier in a
 * leaf does not speak for the others. The tree has at least two points.
 * \param[in] neighbours a search to be asked instead of the tree; empty for none */
Spacing
measureSpacing(const PointTree& tree, const NeighbourDistances& neighbours);

} // namespace pcl::acmap::dewall
