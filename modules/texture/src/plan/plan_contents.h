#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/texture/floor_plan.h>

namespace pcl::acmap {

/** \brief Adds to a plan what is in its rooms: the roles of its walls, leaves in its openings,
 * furniture below the section, and columns.
 *
 * Planes have the role that the map gives them. Without one, sides of boxes that end below the
 * walls are furniture, leaves of recesses are leaves of doors, and level planes from 0.3 m
 * above the floor to the section are furniture. What lies in an opening, parallel to it, is its
 * leaf.
 * \param[in,out] plan of this map, with walls and openings */
void
addContents(const CompactMap& map, FloorPlan& plan);

} // namespace pcl::acmap
