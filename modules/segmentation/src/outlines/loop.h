#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl::acmap::outlines {

/** A closed polygon in a plane, metres; the last point is connected to the first. */
using Loop = std::vector<Eigen::Vector2d>;

/** Cross product, positive if \a b points to the left of \a a. */
double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/** Area in square metres, positive if the loop is counter-clockwise. */
double
signedArea(const Loop& loop);

bool
contains(const Loop& loop, const Eigen::Vector2d& point);

/** Which loops are outer ones, and which are holes of these. */
struct Nesting {
  std::vector<std::size_t> rims; ///< counter-clockwise loops, by falling area
  /** Clockwise loops, each with the place in \a rims of the smallest one around it. */
  std::vector<std::pair<std::size_t, std::size_t>> holes;
};

/** \param[in] min_area area below which loops are left out */
Nesting
nestingOf(const std::vector<Loop>& loops, double min_area);

/** Do the segments ab and cd cross in the interior of both?
 * \param[out] place intersection */
bool
segmentsCross(const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c,
              const Eigen::Vector2d& d,
              Eigen::Vector2d& place);

/** Removes points while all of them are within \a tolerance of the simplified loop
 * (Douglas and Peucker). */
Loop
simplified(const Loop& loop, double tolerance);

/** Removes self-crossings: at each one the smaller part is cut off. */
Loop
uncrossed(Loop loop);

/** Resolves intersections of loops that have a surface on their left: loops that cross
 * or touch themselves or another one are cut at the intersections, and replaced by the
 * boundaries of the area that they enclose. The results share complete vertices only.
 * Loops that keep the distance are unchanged.
 * \param[in] distance points within it are merged, metres; well above the rounding of
 * floats. The rounding of doubles is its lower limit. */
std::vector<Loop>
disentangled(const std::vector<Loop>& loops, double distance);

} // namespace pcl::acmap::outlines
