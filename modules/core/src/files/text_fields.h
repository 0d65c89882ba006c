#pragma once

#include "clouds/field_layout.h"
#include "files/text_number.h"

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief Reads the values of one field from a row of text and stores them in a point.
 * \throws InputFileException when the row ends too early or a word is not a value of
 * this field */
void
storeField(Words& row,
           const FieldLayout& layout,
           std::size_t field,
           std::uint8_t* point,
           const ByteSource& source);

/** \brief Returns the next word of a row.
 * \throws InputFileException when there is none */
std::string_view
nextWord(Words& row, const ByteSource& source);

} // namespace pcl::acmap
