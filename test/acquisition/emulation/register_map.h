#pragma once

#include <cstdint>
#include <map>

namespace pcl::acmap::test {

/** \brief Quadlets by offset, each with the bits that a host may change. */
class RegisterMap {
public:
  /** \brief Adds a register that ignores writes. */
  void
  fix(std::uint32_t offset, std::uint32_t value)
  {
    cells_[offset] = {value, 0};
  }

  /** \brief Adds a register in which the host may change the writable bits. */
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

  /** \brief Changes a register as the camera itself does. */
  void
  set(std::uint32_t offset, std::uint32_t value)
  {
    cells_.at(offset).value = value;
  }

  /** \brief Writes a register as the host does; returns false if it does not exist. */
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
