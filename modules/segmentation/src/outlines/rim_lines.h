#pragma once

#include "outlines/loop.h"

namespace pcl::acmap::outlines {

/** A straight piece of a rim. */
struct RimLine {
  Eigen::Vector2d middle, direction; ///< unit direction, along the rim
  std::size_t from, to;              ///< corners of the rim between which it is fitted

  Eigen::Vector2d
  nearest(const Eigen::Vector2d& place) const
  {
    return middle + (place - middle).dot(direction) * direction;
  }

  /** Intersection with a line.
   * \return false if they are nearly parallel */
  bool
  meet(const Eigen::Vector2d& point,
       const Eigen::Vector2d& along,
       Eigen::Vector2d& place) const;
};

/** Numbers of the corners of a rim that are left if it is simplified within 0.9 cells,
 * first and last included. */
std::vector<std::size_t>
breakPoints(const Loop& rim);

/** The straight pieces of a rim that describe it best: the sum of their squared distances
 * from the sides of the cells, plus a price for each piece, which is lower along an axis,
 * is minimal over all choices of break points.
 * \param[in] rim corners of cells, one cell apart
 * \param[in] noise of the rim in cells, for which a price is paid */
std::vector<RimLine>
rimLines(const Loop& rim, double noise);

/** Moves lines, which follow the cells, to the outermost points of the surface along them.
 * \param[in] rim with the surface on its left
 * \param[in] points of the surface near its rims, in cells
 * \param[in] points_a_bin number of which the outermost one counts, at least in 2 cells:
 * for exact points some, of fewer the outermost one is far inside; for noisy points 0 */
void
refineLines(const Loop& rim,
            const std::vector<Eigen::Vector2d>& points,
            double points_a_bin,
            std::vector<RimLine>& lines);

/** The corners of a polyline along lines: their intersections, or if these are far from
 * the break point, the break point projected onto both. First and last corner are left
 * out. */
Loop
cornersOf(const std::vector<RimLine>& lines, const Loop& rim);

} // namespace pcl::acmap::outlines
