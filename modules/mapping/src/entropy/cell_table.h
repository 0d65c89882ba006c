#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Sums over the points of a cell, as integers, so that they do not depend on
 * the order. */
struct EntropyCellSums {
  std::int64_t column, row; ///< key of the cell
  std::uint64_t weight = 0;
  std::uint64_t x = 0, z = 0;              ///< weight times position
  std::int64_t normal_x = 0, normal_z = 0; ///< weight times normal
};

/** \brief Hash table of cells by their keys. */
class EntropyCellTable {
public:
  EntropyCellTable()
  : places_(4096, none)
  {}

  EntropyCellSums&
  at(std::int64_t column, std::int64_t row)
  {
    std::size_t place = placeOf(column, row);
    while (places_[place] != none) {
      EntropyCellSums& cell = cells_[places_[place]];
      if (cell.column == column && cell.row == row)
        return cell;
      place = (place + 1) & (places_.size() - 1);
    }
    places_[place] = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back({column, row});
    if (4 * cells_.size() > places_.size())
      grow();
    return cells_.back();
  }

  /** \brief All cells in the order of their insertion. */
  std::vector<EntropyCellSums>&
  cells()
  {
    return cells_;
  }

private:
  static constexpr std::uint32_t none = UINT32_MAX;

  std::size_t
  placeOf(std::int64_t column, std::int64_t row) const
  {
    std::uint64_t mixed = static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15u +
                          static_cast<std::uint64_t>(row) * 0xc2b2ae3d27d4eb4fu;
    mixed ^= mixed >> 32;
    mixed *= 0xd6e8feb86659fd93u;
    return static_cast<std::size_t>(mixed >> 32) & (places_.size() - 1);
  }

  void
  grow()
  {
    places_.assign(2 * places_.size(), none);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      std::size_t place = placeOf(cells_[i].column, cells_[i].row);
      while (places_[place] != none)
        place = (place + 1) & (places_.size() - 1);
      places_[place] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<std::uint32_t> places_; ///< open addressing; the size is a power of two
  std::vector<EntropyCellSums> cells_;
};

} // namespace pcl::acmap
