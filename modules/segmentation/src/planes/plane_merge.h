#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Merges regions of one plane, however far apart: their normals have to agree within
 * \a cosine, and a common plane has to fit the points of both within \a distance (root
 * mean square). Smaller regions are merged into larger ones.
 * \return number of regions that were merged into others */
std::size_t
mergePlanes(std::vector<GrownPlane>& planes, double cosine, double distance);

/** Additional root mean square distance of a region from a plane instead of its own
 * one, metres. */
double
excess(const GrownPlane& grown, const Plane& plane);

/** For each hypothesis the number of its region, or no_region. */
std::vector<std::int32_t>
ownersOf(const CellGraph& graph, const std::vector<GrownPlane>& planes);

/** Moves the members of another plane into one; the other one is left empty. */
void
takeIn(GrownPlane& into, GrownPlane& other, const Plane& common);

void
dropEmpty(std::vector<GrownPlane>& planes);

/** Merges adjacent regions without a step between them, if one plane fits both within
 * the usual bending of real surfaces and of sensor data: a floor of 40 m is not
 * perfectly flat, but it is one floor.
 * \return number of regions that were merged into others */
std::size_t
joinContinued(const CellGraph& graph,
              const PlaneLimits& limits,
              double cosine,
              std::vector<GrownPlane>& planes);

} // namespace pcl::acmap::planes
