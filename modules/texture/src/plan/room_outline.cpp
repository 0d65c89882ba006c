#include "plan/room_outline.h"

#include <pcl/core/impl/polyline_corners.h>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

Vector2i
leftOf(const Vector2i& ahead)
{
  return {-ahead.y(), ahead.x()};
}

/** \brief The cell to the left of a step along the border, or to its right.
 * \param[in] corner where the step begins */
Vector2i
cellBeside(const Vector2i& corner, const Vector2i& ahead, bool is_left)
{
  const Vector2i aside = is_left ? leftOf(ahead) : Vector2i(-leftOf(ahead));
  const Vector2i doubled = 2 * corner + ahead + aside; // of its middle
  return {(doubled.x() - 1) / 2, (doubled.y() - 1) / 2};
}

std::vector<Vector2d>
withFewCorners(const std::vector<Vector2d>& loop, double tolerance)
{
  std::size_t far = 0;
  for (std::size_t k = 0; k < loop.size(); ++k)
    if ((loop[k] - loop[0]).squaredNorm() > (loop[far] - loop[0]).squaredNorm())
      far = k;
  std::vector<std::uint8_t> is_kept(loop.size(), 0);
  is_kept[0] = is_kept[far] = 1;
  markKept(loop, 0, far, tolerance, is_kept);
  markKept(loop, far, loop.size(), tolerance, is_kept);
  std::vector<Vector2d> corners;
  for (std::size_t k = 0; k < loop.size(); ++k)
    if (is_kept[k])
      corners.push_back(loop[k]);
  return corners;
}

} // namespace

std::vector<Vector2d>
outlineOfCells(const Vector2i& first,
               const std::function<bool(const Vector2i& cell)>& is_inside,
               double tolerance)
{
  // along the lower side of the first cell, with the region to the left
  std::vector<Vector2d> loop;
  Vector2i corner = first, ahead(1, 0);
  do {
    loop.push_back(corner.cast<double>());
    corner += ahead;
    // cells that touch at a corner only are not beside each other
    if (!is_inside(cellBeside(corner, ahead, true)))
      ahead = leftOf(ahead);
    else if (is_inside(cellBeside(corner, ahead, false)))
      ahead = -leftOf(ahead);
  } while (corner != first || ahead != Vector2i(1, 0));
  return withFewCorners(loop, tolerance);
}

} // namespace pcl::acmap
