#pragma once

#include <Eigen/Core>

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

/** Removes points while all of them are within \a tolerance of the simplified loop
 * (Douglas and Peucker). */
Loop
simplified(const Loop& loop, double tolerance);

/** Removes self-crossings: at each one the smaller part is cut off. */
Loop
uncrossed(Loop loop);

} // namespace pcl::acmap::outlines
