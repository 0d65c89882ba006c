#pragma once

#include <cstdint>
#include <map>

namespace pcl::acmap::test {

/** \brief Quadlets by offset, each with the bits that a host may change. */
class RegisterMap {
public:
  /** \brief A register that ignores writes. */
  void
  fix(std::uint32_t offset, std::uint32_t value)
  {
    cells_[offset] = {value, 0};
  }

  /** \brief A register of which writes change these bits. */
  void
  keep(std::uint32_t offset, std::uint32_t value, std::uint32_t writable = 0xFFFFFFFF)
  {
    cells_[offset] = {value, writable};
  }

  bool
  has(std::uint32_t offset) const
  {
    return cells_.count(offset) != 0;
  }

  std::uint32_t
  at(std::uint32_t offset) const
  {
    return cells_.at(offset).value;
  }

  /** \brief As the camera itself changes a register. */
  void
  set(std::uint32_t offset, std::uint32_t value)
  {
    cells_.at(offset).value = value;
  }

  /** \brief As the host writes: whether there is such a register. */
  bool
  write(std::uint32_t offset, std::uint32_t value)
  {
    const auto cell = cells_.find(offset);
    if (cell == cells_.end())
      return false;
    const std::uint32_t writable = cell->second.writable;
    cell->second.value = (cell->second.value & ~writable) | (value & writable);
    return true;
  }

private:
  struct Cell {
    std::uint32_t value;
    std::uint32_t writable;
  };
  std::map<std::uint32_t, Cell> cells_;
};

} // namespace pcl::acmap::test
