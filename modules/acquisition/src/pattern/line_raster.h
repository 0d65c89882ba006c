#pragma once

#include "pattern_lines.h"

#include <pcl/core/image_file.h>

namespace pcl::acmap {

/** \brief Paints a line over an image; each pixel either belongs to the line or not. */
void
paintLine(const PatternLine& line, RgbImage& image);

/** \brief Creates a black image and paints the lines in order, later ones over earlier
 * ones. */
RgbImage
paintLines(const PatternLaw& law, const std::vector<PatternLine>& lines);

/** \brief Fraction of the pixels that are not black. */
double
coverageOf(const RgbImage& image);

} // namespace pcl::acmap
