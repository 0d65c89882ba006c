#pragma once

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief The split of sorted values into two parts that leaves least of their variance
 * within the parts (Otsu). */
struct Split {
  std::size_t first = 0; ///< number of values in the lower part
  double left = 1;       ///< share of the variance that is left; 1 if all are equal
};

Split
bestSplit(const std::vector<double>& sorted);

} // namespace pcl::acmap
