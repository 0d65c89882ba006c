#pragma once

#include "chain/view_levels.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Features of a view at one level. */
struct FeatureLevel {
  int scale = 1;                       ///< pixels of the view across one of the level
  std::vector<std::int32_t> pixels;    ///< of the view, where the keypoints lie
  std::vector<Eigen::Vector3f> places; ///< metres
  std::vector<float> sigmas;           ///< metres along the ray
  LogPolarPatches patches;
};

FeatureLevel
featureLevel(const ViewLevel& level,
             const CameraView& view,
             const EgomotionSettings& settings);

} // namespace pcl::acmap
