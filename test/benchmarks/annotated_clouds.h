#pragma once

#include "plane_input.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A cloud whose planes were annotated by people or by a renderer. */
struct AnnotatedCloud {
  std::string name;
  PlaneInput input;
  std::vector<std::int32_t> labels; ///< plane of each point, -1 for none
  std::size_t planes = 0;

  /** \brief Median over the annotated planes of the RMS distance of their points,
   * metres; a large value would mean that the file was read incorrectly. */
  double median_rms = 0;
  double largest_rms = 0;
};

/** \brief Calls a function for one cloud after another. Missing clouds are reported on
 * stderr and skipped. */
void
forEachAnnotatedCloud(const std::function<void(const AnnotatedCloud&)>& use);

} // namespace pcl::acmap::bench
