#pragma once

#include "active_stereo/frame_rectifier.h"

#include <pcl/stereo/disparity_fusion.h>

#include <cstdint>
#include <optional>

namespace pcl::acmap {

/** \brief Decides, shot by shot, if an observation needs a further pattern. */
class PatternNeed {
public:
  /** \param[in] rectifier of the camera's frames */
  explicit PatternNeed(FrameRectifier rectifier);

  /** \brief Adds a shot under a pattern, as received from the camera. Returns true if a
   * further pattern is needed. */
  bool
  wantsMoreAfter(const TrinocularFrame& frame);

private:
  FrameRectifier rectifier_;
  DisparityFusion fusion_;
  std::optional<std::int32_t> observation_;
};

} // namespace pcl::acmap
