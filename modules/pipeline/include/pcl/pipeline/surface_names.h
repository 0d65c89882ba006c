#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/texture/floor_plan.h>

namespace pcl {

/** \brief Gives every part of a map its name, role and size: planes, cylinders, boxes,
 * recesses, openings and rooms ("Wall of room 2", \ref SurfaceLabel). Rooms are numbered from
 * 1, by decreasing area.
 *
 * A level plane within 12 cm of the floor of the plan, or within 30 cm if it has a square metre,
 * is a floor, as is one of at least half of the floor's area a storey above or below it. What
 * faces down 1.9 m above the floor, or higher, with half a square metre is a ceiling. An upright
 * plane is a wall if it reaches up to 85 % of the height of the largest ceiling, or 1.9 m where
 * none was seen; if it continues one in the same plane, or is the last one behind furniture and
 * higher than a worktop; or if it was seen above 1.5 m with two square metres. The leaf of a
 * recess that reaches the floor, and a plane of the size of a door that begins at the side of one,
 * are door leaves. The sides of a box that neither hangs from the ceiling nor reaches it, what
 * stands up to 1.2 m in front of a wall, and what is between floor and head in a map with rooms,
 * are furniture. Without a floor only upright planes of at least a square metre that are 1.5 m
 * high have a role, as walls; in a map of less than 1.5 m nothing has one.
 * \param[in] plan from \ref makeFloorPlan for this map
 * \param[in,out] map with the rooms and openings of the plan (\ref setRooms); parts that are
 * not finite keep the role \ref SurfaceRole::Other. \ingroup pipeline */
ACMAP_EXPORT void
nameSurfaces(const FloorPlan& plan, CompactMap& map);

/** \brief The same for a map that has no plan yet: makes it, and gives the map its rooms.
 * \param[in,out] map complete but for its names and rooms
 * \return the plan \ingroup pipeline */
ACMAP_EXPORT FloorPlan
nameParts(CompactMap& map);

} // namespace pcl
