#pragma once

#include "chain/view_levels.h"

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Features of a view at one level. */
struct FeatureLevel {
  int scale = 1;                       ///< size of a pixel in pixels of the view
  std::vector<std::int32_t> pixels;    ///< pixels of the keypoints in the view
  std::vector<Eigen::Vector3f> places; ///< metres
  std::vector<float> sigmas;           ///< metres along the ray
  LogPolarPatches patches;
};

FeatureLevel
featureLevel(const ViewLevel& level,
             const CameraView& view,
             const EgomotionSettings& settings);

} // namespace pcl::acmap
