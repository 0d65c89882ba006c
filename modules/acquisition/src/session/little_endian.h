#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

/** \brief Writes an integer, least significant byte first, and advances the pointer. */
template <typename Unsigned>
void
putNumber(std::uint8_t*& data, Unsigned value)
{
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    *data++ = static_cast<std::uint8_t>(value >> (8 * i));
}

/** \brief Reads an integer that was written by \ref putNumber and advances the
 * pointer. */
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
