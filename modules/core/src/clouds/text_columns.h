#pragma once

#include "clouds/text_layout.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace pcl::acmap {

/** \brief The first lines of a text. */
struct TextHead {
  std::vector<std::string_view> rows;
  std::vector<std::string_view> comments; ///< above the rows, without their signs
  std::vector<std::string_view> lines;    ///< others above the rows, without counts
};

/** \brief Finds separators and decimal commas.
 * \throws InputFileException if commas may mean two things */
void
findSeparators(const TextHead& head, TextLayout& layout, const ByteSource& source);

/** \brief Finds the roles of columns without names by their numbers.
 * \throws InputFileException if the coordinates may be in two places */
void
guessColumns(const TextHead& head,
             bool is_pts,
             TextLayout& layout,
             const ByteSource& source);

} // namespace pcl::acmap
