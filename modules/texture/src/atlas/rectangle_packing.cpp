#include "atlas/rectangle_packing.h"

#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#include <stb_rect_pack.h>

#include <algorithm>

namespace pcl::acmap {

namespace {

/** \brief Packs rectangles into one page in the order in which they are given. */
class PagePacker {
public:
  /** \param[in] size of the page in units */
  explicit PagePacker(const Eigen::Vector2i& size)
  : nodes_(static_cast<std::size_t>(size.x()))
  {
    stbrp_init_target(&context_, size.x(), size.y(), nodes_.data(), size.x());
    stbrp_setup_heuristic(&context_, STBRP_HEURISTIC_Skyline_BF_sortHeight);
  }

  PagePacker(const PagePacker&) = delete;
  PagePacker&
  operator=(const PagePacker&) = delete;

  /** \return false if there is no room left */
  bool
  add(const Eigen::Vector2i& size, Eigen::Vector2i& corner)
  {
    // one by one: the library's own sorting is not stable
    stbrp_rect rectangle{};
    rectangle.w = size.x();
    rectangle.h = size.y();
    if (stbrp_pack_rects(&context_, &rectangle, 1) == 0)
      return false;
    corner = {rectangle.x, rectangle.y};
    return true;
  }

private:
  stbrp_context context_;
  std::vector<stbrp_node> nodes_;
};

using Order = std::vector<std::size_t>;

/** \brief Packs as many rectangles as fit into a page.
 * \return those that are left, in their order */
Order
packPage(const std::vector<Eigen::Vector2i>& sizes,
         const Order& order,
         const Eigen::Vector2i& page,
         std::vector<Eigen::Vector2i>& corners)
{
  PagePacker packer(page);
  Order left;
  for (const std::size_t i : order)
    if (!packer.add(sizes[i], corners[i]))
      left.push_back(i);
  return left;
}

/** \brief The sizes of pages by increasing area, none of them longer than twice its
 * other side. */
std::vector<Eigen::Vector2i>
pageSizes(std::int32_t maximum)
{
  std::vector<Eigen::Vector2i> sizes = {{1, 1}};
  for (std::int32_t side = 1; side < maximum; side *= 2)
    for (const Eigen::Vector2i& size : {Eigen::Vector2i(2 * side, side),
                                        Eigen::Vector2i(side, 2 * side),
                                        Eigen::Vector2i(2 * side, 2 * side)})
      sizes.push_back(size);
  return sizes;
}

} // namespace

Packing
packedRectangles(const std::vector<Eigen::Vector2i>& sizes,
                 std::int32_t unit,
                 std::int32_t maximum)
{
  std::vector<Eigen::Vector2i> units;
  for (const Eigen::Vector2i& size : sizes)
    units.emplace_back((size.array() + unit - 1) / unit);
  Packing packing;
  packing.places.resize(sizes.size());
  Order order;
  for (std::size_t i = 0; i < sizes.size(); ++i)
    if (unit * units[i].maxCoeff() <= maximum)
      order.push_back(i);
    else {
      packing.places[i].page = packing.pages.size();
      packing.pages.push_back(sizes[i]);
    }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return units[a].y() != units[b].y() ? units[a].y() > units[b].y()
                                        : units[a].x() > units[b].x();
  });
  const std::vector<Eigen::Vector2i> candidates = pageSizes(maximum / unit);
  std::vector<Eigen::Vector2i> corners(sizes.size(), Eigen::Vector2i::Zero());
  while (!order.empty()) {
    std::int64_t area = 0;
    for (const std::size_t i : order)
      area += std::int64_t{units[i].x()} * units[i].y();
    Order left = order;
    Eigen::Vector2i page = candidates.back();
    for (const Eigen::Vector2i& candidate : candidates) {
      const bool is_last = candidate == candidates.back();
      if (!is_last && std::int64_t{candidate.x()} * candidate.y() < area)
        continue;
      page = candidate;
      left = packPage(units, order, page, corners);
      if (left.empty())
        break;
    }
    for (const std::size_t i : order)
      packing.places[i] = {packing.pages.size(), unit * corners[i]};
    packing.pages.emplace_back(unit * page); // the places of those left are set again
    order = std::move(left);
  }
  return packing;
}

} // namespace pcl::acmap
