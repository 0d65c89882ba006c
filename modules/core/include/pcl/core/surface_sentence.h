#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>

#include <cstddef>
#include <string>

namespace pcl {

/** \brief Describes a plane as people would: "Wall of room 2, 31.5 m², 7.1 × 4.0 m, door 0.97
 * × 2.40 m, noise 6.8 mm"; UTF-8. A plane without a name is "Plane 3". What is not known is
 * left out.
 * \param[in] plane index in the map
 * \throws BadArgumentException when the map has no such plane \ingroup core */
ACMAP_EXPORT std::string
describePlane(const CompactMap& map, std::size_t plane);

/** \brief The same for a room: "Room 1, 24.8 m², 6.2 × 4.0 m, 2 doors, 1 window".
 * \ingroup core */
ACMAP_EXPORT std::string
describeRoom(const CompactMap& map, std::size_t room);

/** \brief The same for a cylinder: "Column in room 1, diameter 0.31 m, 2.70 m long, noise 2.1
 * mm". \ingroup core */
ACMAP_EXPORT std::string
describeCylinder(const CompactMap& map, std::size_t cylinder);

} // namespace pcl
