#pragma once

#include <pcl/mapping/entropy_rectification_types.h>

#include <vector>

namespace pcl::acmap {

/** \brief Is the energy of both the same function of the poses? Only within one search
 * and size of bins it is. */
bool
areComparable(const RectificationStep& a, const RectificationStep& b);

/** \brief Each step's energy above the lowest of its kind; NaN where it is not finite. */
std::vector<double>
energiesAboveLowest(const std::vector<RectificationStep>& steps);

/** \brief What a picture of the energies shows. */
struct EnergyRange {
  double least, most;

  double
  length() const
  {
    return most - least;
  }
};

/** \brief From 0 to what all but the highest ones are below.
 * \param[in] heights of \ref energiesAboveLowest */
EnergyRange
shownRange(std::vector<double> heights);

} // namespace pcl::acmap
