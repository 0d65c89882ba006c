#pragma once

#include "drawing.h"

#include <pcl/mapping/entropy_rectification_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief The energy over the steps of the search, a colour for each search. Energies
 * are comparable within one search and size of bins only: each is drawn above the
 * lowest of its kind, and a line is broken where the kind changes. Those far above the
 * others leave the picture. */
RgbImage
energyPicture(const std::vector<RectificationStep>& steps);

} // namespace pcl::acmap
