#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Hash grid of points with cells of twice a radius, so that a ball of that
 * radius overlaps at most eight of them. Different cells may share a chain, so the
 * caller must check distances. */
class PointHash {
public:
  /** \param[in] capacity maximum number of points; their indices are 0 to capacity - 1
   * \param[in] radius metres */
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

  /** \brief Calls visit (name) for the points in the cells around a position, until it
   * returns true. Points that were added to a cell later come first; a point may be
   * visited twice because of hash collisions. */
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
