#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::acmap {

/** \brief The outer border of a connected region of cells as a polygon with few corners,
 * counter-clockwise, in cells: cell (column, row) covers column to column + 1, row to row + 1.
 *
 * \param[in] first any cell of the lowest row of the region that has the region's cells,
 * of these the one with the lowest column
 * \param[in] is_inside whether a cell belongs to the region; called inside of the region and
 * beside it only
 * \param[in] tolerance how far the corners between those of the polygon may be from it, cells
 */
std::vector<Eigen::Vector2d>
outlineOfCells(const Eigen::Vector2i& first,
               const std::function<bool(const Eigen::Vector2i& cell)>& is_inside,
               double tolerance);

} // namespace pcl::acmap
