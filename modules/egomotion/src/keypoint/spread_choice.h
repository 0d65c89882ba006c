#pragma once

#include <pcl/egomotion/keypoint_kernel.h>

namespace pcl::acmap {

/** \brief A maximum of the gradient. */
struct GradientMaximum {
  std::int32_t pixel = 0;
  float squared_gradient = 0;
};

/** \brief As many as asked for, see \ref gradientMaxima; of the last turn the
 * strongest.
 * \return pixels, rising */
std::vector<std::int32_t>
spreadChoice(std::vector<GradientMaximum> maxima,
             int width,
             const KeypointSettings& settings);

} // namespace pcl::acmap
