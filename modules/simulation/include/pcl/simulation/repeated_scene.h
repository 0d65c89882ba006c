#pragma once

#include <pcl/core/export.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstddef>

namespace pcl {

/** \brief A building of several copies of a scene, one beside the other: a building of any
 * size for which the truth is known.
 *
 * The copies are in rows along x and z, 2 m apart, and have nothing in common. Copy k is in
 * column k % columns; its views follow those of copy k - 1, and its names end in
 * " (column, row)", except those of the first one.
 * \throws BadArgumentException for no columns or rows \ingroup simulation */
ACMAP_EXPORT SimulatedScene
repeatedScene(const SimulatedScene& scene, std::size_t columns, std::size_t rows);

} // namespace pcl
