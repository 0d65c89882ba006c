#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Where a rectangle is: the page, and its column and row from the top left. */
struct PackedPlace {
  std::size_t page = 0;
  Eigen::Vector2i corner = Eigen::Vector2i::Zero();
};

/** \brief Places of rectangles without overlap, in their order. */
struct Packing {
  std::vector<PackedPlace> places;
  std::vector<Eigen::Vector2i> pages; ///< width and height
};

/** \brief Packs rectangles into few pages by the skyline rule of stb_rect_pack, from the
 * highest to the lowest. A page is as small as its rectangles allow, and a second one is
 * only begun when the first one has the maximum size. A rectangle that is longer than a
 * page gets one of its own, of its size. The result depends only on the sizes and their
 * order.
 * \param[in] sizes width and height, at least 1
 * \param[in] unit power of two of which all places are multiples
 * \param[in] maximum width and height of a page; like those, a power of two */
Packing
packedRectangles(const std::vector<Eigen::Vector2i>& sizes,
                 std::int32_t unit,
                 std::int32_t maximum);

} // namespace pcl::acmap
