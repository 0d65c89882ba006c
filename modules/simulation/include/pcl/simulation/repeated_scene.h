#pragma once

#include <pcl/core/export.h>
#include <pcl/simulation/simulated_observation.h>
#include <pcl/simulation/simulated_scene.h>

#include <cstddef>
#include <cstdint>

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

/** \brief Measures a view of a \ref repeatedScene, each copy with noise of its own. The copies do
 * not see each other, so that one scene is enough; labels are those of the building.
 * \param[in] scene without its copies
 * \param[in] view of the building
 * \throws what \ref observe does \ingroup simulation */
ACMAP_EXPORT SimulatedObservation
observeRepeated(const SimulatedScene& scene, std::size_t view, std::uint64_t seed);

} // namespace pcl
