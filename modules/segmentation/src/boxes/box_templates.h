#pragma once

#include "boxes/box.h"

#include <cstddef>
#include <vector>

namespace pcl::acmap::boxes {

/** Which orders of the axes are equal. */
enum class SizeOrder {
  Any,  ///< a template has that of its first box, in which sizes fall
  Given ///< none but that of each box
};

/** Gives boxes whose sizes agree within their standard deviations one size, fitted to
 * all of them, and one number; turns their axes so that sizes have the same order, where
 * any is equal.
 * Sorts them by falling volume.
 * \return the number of templates */
std::size_t
shareSizes(std::vector<Box>& boxes, SizeOrder order);

} // namespace pcl::acmap::boxes
