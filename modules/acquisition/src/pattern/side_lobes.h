#pragma once

#include <pcl/core/image_file.h>

#include <vector>

namespace pcl::acmap {

/** \brief How alike a row is to itself elsewhere: the highest correlation coefficient of
 * the row with itself shifted, over the shifts of the disparity range behind the main
 * lobe. That ends at the first minimum at or behind the first value below 0.5.
 * \param[in] values brightness along the row
 * \param[in] range largest shift; at most half of the row is looked at
 * \return within [0, 1]; 1 where the main lobe has no end, as in a row of one value */
double
sideLobeOf(const std::vector<int>& values, int range);

/** \brief A pattern is good where its gated side lobes are below. */
constexpr double highest_side_lobe = 0.5;

/** \brief The side lobes of an image's rows or columns. */
struct SideLobes {
  double gated = 0; ///< 99th percentile: what patterns are accepted by
  double worst = 0;
};

/** \brief Side lobes along the rows, by the sum of the channels; of 256 rows, evenly
 * spread, where there are more. */
SideLobes
rowSideLobes(const RgbImage& image, int range);

/** \brief The same along the columns. */
SideLobes
columnSideLobes(const RgbImage& image, int range);

} // namespace pcl::acmap
