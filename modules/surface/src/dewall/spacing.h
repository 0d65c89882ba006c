#pragma once

#include "point_tree.h"

#include <vector>

namespace pcl::acmap::dewall {

/** \brief How far apart the points of each leaf of the tree stand, metres. */
struct Spacing {
  std::vector<double> nearest; ///< for each, from a point to its nearest neighbour
  std::vector<double> eighth;  ///< and to its eighth: 1.41 spacings on a square grid

  /** \brief Median of \ref nearest. */
  double
  median() const;
};

/** \brief Looks at two points a leaf and takes the lesser values, so that one outlier in a
 * leaf does not speak for the others. The tree has at least two points. */
Spacing
measureSpacing(const PointTree& tree);

} // namespace pcl::acmap::dewall
