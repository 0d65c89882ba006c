#pragma once

#include <pcl/core/image_file.h>

#include <vector>

namespace pcl::acmap {

/** \brief Self-similarity of a row: the maximum correlation coefficient of the row with
 * its shifted copy, over the shifts of the disparity range beyond the main lobe. The
 * main lobe ends at the first minimum at or after the first value below 0.5.
 * \param[in] values brightness along the row
 * \param[in] range maximum shift; at most half of the row is examined
 * \return within [0, 1]; 1 if the main lobe has no end, for example in a constant
 * row */
double
sideLobeOf(const std::vector<int>& values, int range);

/** \brief A pattern is accepted if its gated side lobes are below this value. */
constexpr double highest_side_lobe = 0.5;

/** \brief The side lobes of an image's rows or columns. */
struct SideLobes {
  double gated = 0; ///< 99th percentile, which decides about acceptance
  double worst = 0;
};

/** \brief Side lobes along the rows, computed from the sum of the channels. If there
 * are more than 256 rows, 256 of them are used, evenly distributed. */
SideLobes
rowSideLobes(const RgbImage& image, int range);

/** \brief The same along the columns. */
SideLobes
columnSideLobes(const RgbImage& image, int range);

} // namespace pcl::acmap
