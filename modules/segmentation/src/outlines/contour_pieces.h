#pragma once

#include "outlines/creases.h"

namespace pcl::acmap::outlines {

/** Part of a boundary of cells: along a crease, or free. */
struct ContourPiece {
  static constexpr std::int32_t free = -1;

  std::int32_t crease = free; ///< number of the crease
  int side = 0;               ///< side of the crease on which the surface is
  std::size_t first = 0;      ///< corner of the boundary at which the piece begins
  std::size_t count = 0;      ///< sides of cells
};

/** Divides a boundary into its parts along creases and free ones. Short touches of a
 * crease are not counted, short gaps of one are closed, and where two creases meet
 * nothing is free between them.
 * \param[in] contour corners of cells, in order
 * \return pieces in the order of the boundary; the last one is followed by the first */
std::vector<ContourPiece>
piecesOf(const Loop& contour, std::size_t plane, const Creases& creases);

/** Where two creases of a plane meet, if it is near a part of the boundary.
 * \return false if it is not */
bool
meetNear(const Crease& a,
         const Crease& b,
         std::size_t plane,
         const Eigen::Vector2d& begin,
         const Eigen::Vector2d& end,
         Eigen::Vector2d& place);

} // namespace pcl::acmap::outlines
