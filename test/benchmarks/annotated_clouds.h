#pragma once

#include "plane_input.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A cloud whose planes people, or a renderer, have marked. */
struct AnnotatedCloud {
  std::string name;
  PlaneInput input;
  std::vector<std::int32_t> labels; ///< for each point index of its plane, -1 for none
  std::size_t planes = 0;

  /** \brief Root mean square of the points of a marked plane off it, metres: if the middle
   * one were large, the file would have been read wrongly. */
  double median_rms = 0;
  double largest_rms = 0;
};

/** \brief Calls a function for one cloud after the other. Those that are not there are
 * named on stderr and left out. */
void
forEachAnnotatedCloud(const std::function<void(const AnnotatedCloud&)>& use);

} // namespace pcl::acmap::bench
