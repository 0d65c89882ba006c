#pragma once

#include "drawing.h"

#include <pcl/mapping/entropy_rectification_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief Are the energies of both the same function of the poses? This holds only
 * within one search and bin size. */
bool
areComparable(const RectificationStep& a, const RectificationStep& b);

/** \brief Energy of each step above the minimum of the comparable steps; NaN if it is
 * not finite. */
std::vector<double>
energiesAboveLowest(const std::vector<RectificationStep>& steps);

/** \brief Range of energies in a picture. */
struct EnergyRange {
  double minimum, maximum;

  double
  length() const
  {
    return maximum - minimum;
  }
};

/** \brief A range that includes 0 and all but the highest values.
 * \param[in] heights of \ref energiesAboveLowest */
EnergyRange
shownRange(std::vector<double> heights);

/** \brief Plots the energy over the steps of the search, with one colour per search.
 * Energies are comparable only within one search and bin size: each is plotted relative
 * to the minimum of the comparable steps, and the line is interrupted between them.
 * Much higher energies are clipped. */
RgbImage
energyPicture(const std::vector<RectificationStep>& steps);

} // namespace pcl::acmap
