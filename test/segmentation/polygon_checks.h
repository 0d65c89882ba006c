#pragma once

#include <pcl/core/plane_patch.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap::test {

using FlatLoop = std::vector<Eigen::Vector2d>;

/** \brief A loop of a patch in 2D coordinates of its plane, seen from the side of its
 * normal. */
FlatLoop
flattened(const PlanePatch& patch, const std::vector<Eigen::Vector3f>& loop);

/** \brief Signed area in square metres, positive for counter-clockwise loops; sums
 * triangles about the first point. */
double
areaOf(const FlatLoop& loop);

/** \brief Is a point inside? Uses the winding number. */
bool
isInside(const FlatLoop& loop, const Eigen::Vector2d& place);

/** \brief Number of pairs of non-adjacent edges that intersect: 0 for a simple loop. */
std::size_t
countCrossings(const FlatLoop& loop);

/** \brief Number of intersections between two loops. */
std::size_t
countCrossings(const FlatLoop& a, const FlatLoop& b);

/** \brief Distance from a point to the nearest point of a loop's line, metres. */
double
distanceToLine(const FlatLoop& loop, const Eigen::Vector2d& place);

/** \brief Checks the guarantees of PlanePolygon: on the plane, simple, outlines
 * counter-clockwise, holes clockwise and inside their outlines, correct area. */
void
expectSound(const PlanePatch& patch);

} // namespace pcl::acmap::test
