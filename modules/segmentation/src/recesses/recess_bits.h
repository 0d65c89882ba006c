#pragma once

#include "boxes/box_bits.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::recesses {

/** Sets the bits of the leaf of a recess and of the opening in the wall, and those that
 * the recess saves.
 * \param[in] templates number of sizes that are already described
 * \param[in] is_instance the size is one of these */
void
measureRecessBits(const std::vector<PlanePatch>& planes,
                  const std::vector<boxes::Piece>& pieces,
                  const boxes::MapScale& scale,
                  std::size_t templates,
                  bool is_instance,
                  boxes::Box& recess);

} // namespace pcl::acmap::recesses
