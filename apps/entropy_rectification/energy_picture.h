#pragma once

#include "drawing.h"

#include <pcl/mapping/entropy_rectification_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief Plots the energy over the steps of the search, with one colour per search.
 * Energies are comparable only within one search and bin size: each is plotted relative
 * to the minimum of the comparable steps, and the line is interrupted between them.
 * Much higher energies are clipped. */
RgbImage
energyPicture(const std::vector<RectificationStep>& steps);

} // namespace pcl::acmap
