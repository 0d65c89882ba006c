#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A line of text as strokes, as a pen plotter writes it. The unit is the height of a
 * capital letter; the origin is at the left end, halfway up the capital letters. */
struct StrokedText {
  std::vector<std::vector<Eigen::Vector2d>> strokes; ///< one point is a dot
  double width = 0;
};

/** \brief Accents are left out, and what has no glyph is a box.
 * \param[in] text UTF-8; invalid bytes have no glyph */
StrokedText
strokesOf(const std::string& text);

/** \brief The width of a text, in heights of its capital letters. */
double
widthOf(const std::string& text);

} // namespace pcl::acmap
