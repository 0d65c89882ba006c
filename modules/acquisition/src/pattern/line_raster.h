#pragma once

#include "pattern_lines.h"

#include <pcl/core/image_file.h>

namespace pcl::acmap {

/** \brief Paints a line over what is there; every pixel is of the line or not. */
void
paintLine(const PatternLine& line, RgbImage& image);

/** \brief A black image with the lines on it, later ones over earlier ones. */
RgbImage
paintLines(const PatternLaw& law, const std::vector<PatternLine>& lines);

/** \brief Share of the pixels that are not black. */
double
coverageOf(const RgbImage& image);

} // namespace pcl::acmap
