#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap::outlines {

/** A closed line in a plane, metres; the last point joins the first. */
using Loop = std::vector<Eigen::Vector2d>;

/** Positive where \a b points to the left of \a a. */
double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/** Square metres, positive where it runs counter-clockwise. */
double
signedArea(const Loop& loop);

bool
contains(const Loop& loop, const Eigen::Vector2d& point);

/** Leaves points out as long as none of them was farther than \a tolerance from what is
 * left (Douglas and Peucker). */
Loop
simplified(const Loop& loop, double tolerance);

/** Cuts off the smaller side wherever the line crosses itself. */
Loop
uncrossed(Loop loop);

} // namespace pcl::acmap::outlines
