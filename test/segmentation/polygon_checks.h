#pragma once

#include <pcl/core/plane_patch.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap::test {

using FlatLoop = std::vector<Eigen::Vector2d>;

/** \brief A loop of a patch in the plane's own coordinates, seen from the side its normal
 * points to. */
FlatLoop
flattened(const PlanePatch& patch, const std::vector<Eigen::Vector3f>& loop);

/** \brief Square metres, positive where it runs counter-clockwise; by triangles about the
 * first point. */
double
areaOf(const FlatLoop& loop);

/** \brief Does a point lie inside? By the angle under which the loop is seen. */
bool
isInside(const FlatLoop& loop, const Eigen::Vector2d& place);

/** \brief Pairs of edges that meet though they are no neighbours: 0 in a simple loop. */
std::size_t
countCrossings(const FlatLoop& loop);

/** \brief The same between two loops. */
std::size_t
countCrossings(const FlatLoop& a, const FlatLoop& b);

/** \brief Metres from a place to the nearest point of a loop's line. */
double
distanceToLine(const FlatLoop& loop, const Eigen::Vector2d& place);

/** \brief Expects of all polygons what PlanePolygon promises: on the plane, simple, rims
 * counter-clockwise, holes clockwise and inside of their rims, and the area theirs. */
void
expectSound(const PlanePatch& patch);

} // namespace pcl::acmap::test
