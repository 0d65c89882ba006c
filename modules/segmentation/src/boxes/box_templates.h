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

/** Calls measure (box, number of sizes that are described before, is its size one of
 * these?) for each box with a shared size, in their order.
 * \param[in] templates number of sizes */
template <typename Measure>
void
measureInstances(std::size_t templates, const Measure& measure, std::vector<Box>& boxes)
{
  std::vector<bool> is_described(templates, false);
  std::size_t described = 0;
  for (Box& box : boxes) {
    const auto number = static_cast<std::size_t>(box.template_id);
    measure(box, described, is_described[number]);
    described += is_described[number] ? 0 : 1;
    is_described[number] = true;
  }
}

} // namespace pcl::acmap::boxes
