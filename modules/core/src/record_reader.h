#pragma once

#include "field_layout.h"

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief Reverses the byte order of all values of \a count packed records. */
void
swapRecords(const FieldLayout& layout, std::uint8_t* records, std::size_t count);

/** \brief Reads \a count binary records into points, without a copy if the layout
 * allows it. The caller has checked that the source contains them. */
void
readRecords(ByteSource& source,
            const FieldLayout& layout,
            bool swap_bytes,
            std::size_t count,
            std::uint8_t* points);

} // namespace pcl::acmap
