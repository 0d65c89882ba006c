#pragma once

#include "field_layout.h"
#include "text_number.h"

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief Reads the values of one field from a row of text into their place in a point.
 * \throws InputFileException when the row ends before them or a word is no such value */
void
storeField(Words& row,
           const FieldLayout& layout,
           std::size_t field,
           std::uint8_t* point,
           const ByteSource& source);

/** \brief The next word of a row.
 * \throws InputFileException when there is none */
std::string_view
nextWord(Words& row, const ByteSource& source);

} // namespace pcl::acmap
