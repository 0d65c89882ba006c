#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::acmap {

/** \brief Key of the cell of a place. */
inline std::uint64_t
cellKey(const Eigen::Vector3d& place, double edge, int dx = 0, int dy = 0, int dz = 0)
{
  constexpr std::int64_t half = 1 << 20;
  const auto part = [edge](double value, int step) {
    const double cell = std::floor(value / edge) + step;
    return static_cast<std::uint64_t>(std::clamp<double>(cell, 1 - half, half - 1) +
                                      half);
  };
  return part(place.x(), dx) << 42 | part(place.y(), dy) << 21 | part(place.z(), dz);
}

/** \brief Numbers in cubic cells. */
class MapCells {
public:
  /** \param[in] edge metres */
  explicit MapCells(double edge)
  : edge_(edge)
  {}

  void
  add(const Eigen::Vector3d& place, std::size_t number)
  {
    cells_[cellKey(place, edge_)].push_back(number);
  }

  /** \brief Calls visit (numbers) for the cell of a place and those around it, in an
   * order that depends on nothing else. */
  template <typename Visit>
  void
  visitAround(const Eigen::Vector3d& place, const Visit& visit)
  {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto cell = cells_.find(cellKey(place, edge_, dx, dy, dz));
          if (cell != cells_.end())
            visit(cell->second);
        }
  }

  /** \brief Collects the numbers of the cell of a place and of those around it. */
  void
  collect(const Eigen::Vector3d& place, std::vector<std::size_t>& found)
  {
    found.clear();
    visitAround(place, [&](const std::vector<std::size_t>& numbers) {
      found.insert(found.end(), numbers.begin(), numbers.end());
    });
  }

private:
  double edge_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

} // namespace pcl::acmap
