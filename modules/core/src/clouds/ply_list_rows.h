#pragma once

#include "clouds/ply_header.h"
#include "files/byte_source.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

namespace pcl::acmap {

/** \brief Reads an unsigned number from a file. */
template <typename Value>
Value
loadUnsigned(const char* from, bool swap)
{
  Value value;
  std::memcpy(&value, from, sizeof value);
  if constexpr (sizeof value == 2)
    return swap ? __builtin_bswap16(value) : value;
  else if constexpr (sizeof value == 4)
    return swap ? __builtin_bswap32(value) : value;
  else
    return value;
}

/** \brief Layout of the rows of a binary element with a single list, such as faces. */
struct PlyListRow {
  /** \brief Limit of the lengths of \ref forShortLists. A length below it has the same
   * value in types with and without a sign. */
  static constexpr std::uint32_t long_list = 128;

  const PlyProperty* list = nullptr; // a property of the element
  std::size_t before = 0;            // bytes of a row before the list
  std::size_t length_bytes = 0;
  std::size_t value_bytes = 0;
  std::size_t after = 0; // bytes of a row after the list
  bool swap = false;

  /** \brief Position of the first value of the list in its row. */
  std::size_t
  valuesBegin() const
  {
    return before + length_bytes;
  }

  /** \brief Number of bytes of a row whose list has \a length values. */
  std::size_t
  bytes(std::uint32_t length) const
  {
    return valuesBegin() + length * value_bytes + after;
  }

  std::uint32_t
  lengthOf(const char* row) const
  {
    switch (length_bytes) {
    case 1:
      return loadUnsigned<std::uint8_t>(row + before, swap);
    case 2:
      return loadUnsigned<std::uint16_t>(row + before, swap);
    default:
      return loadUnsigned<std::uint32_t>(row + before, swap);
    }
  }
};

/** \brief Returns the layout of the rows of an element; nothing if they are text or do
 * not have exactly one list. */
std::optional<PlyListRow>
planListRow(const PlyElement& element, PlyHeader::Encoding encoding);

/** \brief Reads rows where they are in the buffer of a source, and stops before the
 * first one that has a long list or is incomplete. Such rows, and with them all faults,
 * are left to the reader of single values.
 * \param[in] rows maximum number of rows
 * \param[in] use called with (row, length of its list); returns false to stop before
 * this row
 * \return number of rows that were read */
template <typename Use>
std::uint64_t
forShortLists(ByteSource& source,
              const PlyListRow layout, // a copy stays in registers
              const std::uint64_t rows,
              const Use use)
{
  std::uint64_t done = 0;
  std::size_t used = 1;
  while (done < rows && used > 0) {
    const std::string_view block = source.ahead(layout.bytes(PlyListRow::long_list));
    const char* row = block.data();
    const char* const end = row + block.size();
    // Most rows have a list as long as that of the row before: the position of the next
    // one is then known without waiting for the length.
    std::uint32_t length = 0;
    std::size_t bytes = layout.bytes(length);
    for (; done < rows; ++done, row += bytes) {
      if (static_cast<std::size_t>(end - row) < layout.bytes(0))
        break;
      const std::uint32_t found = layout.lengthOf(row);
      if (found >= PlyListRow::long_list)
        break;
      if (found != length) {
        length = found;
        bytes = layout.bytes(length);
      }
      if (static_cast<std::size_t>(end - row) < bytes || !use(row, length))
        break;
    }
    used = static_cast<std::size_t>(row - block.data());
    source.skip(used);
  }
  return done;
}

} // namespace pcl::acmap
