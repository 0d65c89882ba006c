#pragma once

#include "boxes/box.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::boxes {

/** Gives boxes whose sizes agree within their standard deviations one size, fitted to
 * all of them, and one number; turns their axes so that sizes have the same order.
 * Sorts them by falling volume.
 * \return the number of templates */
std::size_t
shareSizes(std::vector<Box>& boxes);

} // namespace pcl::acmap::boxes
