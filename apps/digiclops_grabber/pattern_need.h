#pragma once

#include "active_stereo/frame_rectifier.h"

#include <pcl/stereo/disparity_fusion.h>

#include <cstdint>
#include <optional>

namespace pcl::acmap {

/** \brief Tells, shot by shot, whether an observation needs a further pattern. */
class PatternNeed {
public:
  /** \param[in] rectifier of the camera's frames */
  explicit PatternNeed(FrameRectifier rectifier);

  /** \brief Takes a shot under a pattern, as the camera gave it. */
  bool
  wantsMoreAfter(const TrinocularFrame& frame);

private:
  FrameRectifier rectifier_;
  DisparityFusion fusion_;
  std::optional<std::int32_t> observation_;
};

} // namespace pcl::acmap
