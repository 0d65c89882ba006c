#pragma once

#include <cstddef>

namespace pcl::acmap::recesses {

/** A recess is a box whose axes are width, height and the normal of its wall. Its sides
 * are in the order of BoxPatch::faces. */
constexpr std::size_t right_side = 0, left_side = 1, head_side = 2, foot_side = 3,
                      wall_side = 4, leaf_side = 5;

} // namespace pcl::acmap::recesses
