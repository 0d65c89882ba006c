#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Writes a whole number, its lowest byte first, and moves on behind it. */
template <typename Unsigned>
void
putNumber(std::uint8_t*& data, Unsigned value)
{
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    *data++ = static_cast<std::uint8_t>(value >> (8 * i));
}

/** \brief Reads such a number and moves on behind it. */
template <typename Unsigned>
Unsigned
takeNumber(const std::uint8_t*& data)
{
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    value |= static_cast<Unsigned>(Unsigned{*data++} << (8 * i));
  return value;
}

} // namespace pcl::acmap
