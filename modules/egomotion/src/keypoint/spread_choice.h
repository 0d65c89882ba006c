#pragma once

#include <pcl/egomotion/keypoint_kernel.h>

namespace pcl::acmap {

/** \brief A maximum of the gradient. */
struct GradientMaximum {
  std::int32_t pixel = 0;
  float squared_gradient = 0;
};

/** \brief Selects the maximum number of keypoints, see \ref gradientMaxima; in the last
 * turn, the strongest ones.
 * \return pixels in ascending order */
std::vector<std::int32_t>
spreadChoice(std::vector<GradientMaximum> maxima,
             int width,
             const KeypointSettings& settings);

} // namespace pcl::acmap
