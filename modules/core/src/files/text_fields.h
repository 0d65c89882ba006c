#pragma once

#include "clouds/field_layout.h"
#include "files/text_number.h"

#include <cstddef>
#include <cstdint>

namespace pcl::acmap {

class ByteSource;

/** \brief The words of a row of text, which may be broken into several lines. */
class TextRow {
public:
  /** \param[in] line the first one
   * \param[in] is_breakable the row goes on in the next line if values are missing */
  TextRow(std::string_view line, ByteSource& source, bool is_breakable)
  : words_(line)
  , source_(source)
  , is_breakable_(is_breakable)
  {}

  /** \brief Returns the next word.
   * \throws InputFileException when there is none */
  std::string_view
  next();

  /** \brief Are there words left?
   * \throws InputFileException if they are in a line after the first one: then the row is not
   * broken, but too short */
  bool
  finish();

private:
  Words words_;
  ByteSource& source_;
  bool is_breakable_, is_broken_ = false;
};

/** \brief Reads the values of one field from a row of text and stores them in a point.
 * \param[out] place x, y, z of the point as they are in the text
 * \throws InputFileException when the row ends too early or a word is not a value of
 * this field */
void
storeField(TextRow& row,
           const FieldLayout& layout,
           std::size_t field,
           std::uint8_t* point,
           double* place,
           const ByteSource& source);

} // namespace pcl::acmap
