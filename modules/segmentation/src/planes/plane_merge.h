#pragma once

#include "planes/plane_growth.h"

namespace pcl::acmap::planes {

/** Joins regions of one plane, however far apart: where their normals agree within
 * \a cosine and a common plane takes the points of both within \a distance (root mean
 * square). Larger ones take in smaller ones.
 * \return number of regions that were taken in */
std::size_t
mergePlanes(std::vector<GrownPlane>& planes, double cosine, double distance);

/** How much worse a plane fits a region than its own one, metres. */
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

} // namespace pcl::acmap::planes
