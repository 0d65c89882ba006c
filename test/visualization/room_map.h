#pragma once

#include <pcl/core/compact_map.h>

namespace pcl::acmap::test {

/** \brief A room of 6 x 4 m, 2.5 m high, seen from inside, y down: walls 0 to 3 (at +z
 * with a door, +x, -z, -x with a window), floor 4 and ceiling 5. The textures of the
 * walls are red, green, blue, yellow with a checkerboard and a white upper left
 * quarter; the floor has two tiles of light and dark grey, the ceiling is cyan. It has
 * no trajectory. */
CompactMap
makeRoomMap();

/** \brief A trajectory along the room's length at camera height, looking along +x. */
Trajectory
makeRoomWay();

} // namespace pcl::acmap::test
