#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/texture/floor_plan.h>

#include <string>

namespace pcl {

/** \brief Writes a map as a building model, IFC4 (ISO 16739-1) in a STEP file, metres, z
 * up, one storey.
 *
 * Upright planes become walls, level planes that face up at the height of the plan's floor slabs, those that face
 * down ceilings (coverings), and all others, such as table tops, proxies. Boxes, and cylinders that
 * are no columns, are proxies, upright cylinders that were seen from outside columns, leaves of
 * recesses that reach the floor doors. Each element has the triangles of its surface, not a
 * solid: what is behind a wall is unknown. Openings of the graph of rooms
 * (\ref setRooms) void their walls, rooms are spaces with their area, extruded from their outline. The property
 * set `acmap_Plane` has area, support, rms and the covariance of a plane. The same map
 * gives the same bytes, identifiers and time stamp included.
 * \param[in] plan from \ref makeFloorPlan for this map
 * \throws BadArgumentException when a normal is zero or not finite
 * \throws OutputFileException when the file could not be written \ingroup texture */
ACMAP_EXPORT void
saveMapIfc(const std::string& path, const CompactMap& map, const FloorPlan& plan);

} // namespace pcl
