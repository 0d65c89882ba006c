#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Points by cells of twice a radius, so that a ball of that radius meets eight of
 * them. Cells share chains by chance: the caller looks at distances. */
class PointHash {
public:
  /** \param[in] capacity largest number of points; they are named 0 to capacity - 1 */
  PointHash(std::size_t capacity, float radius)
  : cell_(2 * radius)
  , next_(capacity, -1)
  {
    std::size_t size = 16;
    while (size < capacity)
      size *= 2;
    heads_.assign(size, -1);
  }

  void
  add(std::uint32_t name, const Eigen::Vector3f& point)
  {
    std::int32_t& head = heads_[slotOf((point.array() / cell_).floor())];
    next_[name] = head;
    head = static_cast<std::int32_t>(name);
  }

  /** \brief Calls visit (name) for the points in the cells about a place, until it returns
   * true. Later ones of a cell come first; chance may bring one twice. */
  template <typename Visit>
  void
  visitNear(const Eigen::Vector3f& point, const Visit& visit) const
  {
    const Eigen::Array3f cells = point.array() / cell_;
    const Eigen::Array3f middle = cells.floor();
    const Eigen::Array3f nearer =
        (cells - middle < 0.5f).select(middle - 1, middle + 1);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Array3f cell(corner & 1 ? nearer[0] : middle[0],
                                corner & 2 ? nearer[1] : middle[1],
                                corner & 4 ? nearer[2] : middle[2]);
      for (std::int32_t name = heads_[slotOf(cell)]; name >= 0;
           name = next_[static_cast<std::size_t>(name)])
        if (visit(static_cast<std::uint32_t>(name)))
          return;
    }
  }

private:
  std::size_t
  slotOf(const Eigen::Array3f& cell) const
  {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis)
      hash =
          (hash + static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]))) *
          0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash >> 32) & (heads_.size() - 1);
  }

  float cell_; // metres
  std::vector<std::int32_t> heads_;
  std::vector<std::int32_t> next_;
};

} // namespace pcl::acmap
