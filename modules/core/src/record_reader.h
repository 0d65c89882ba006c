#pragma once

#include "field_layout.h"

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief Turns every value of \a count packed records around. */
void
swapRecords(const FieldLayout& layout, std::uint8_t* records, std::size_t count);

/** \brief Reads \a count binary records into points; straight into place where the layout
 * allows. The caller has checked that the source holds them. */
void
readRecords(ByteSource& source,
            const FieldLayout& layout,
            bool swap_bytes,
            std::size_t count,
            std::uint8_t* points);

} // namespace pcl::acmap
