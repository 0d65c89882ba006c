#pragma once

#include "chain/appearance_level.h"
#include "chain/surface_blocks.h"
#include "chain/view_levels.h"

#include <pcl/core/pinhole.h>
#include <pcl/egomotion/impl/egomotion_kernel.h>

#include <cstdint>
#include <optional>
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

struct EgomotionView {
  std::size_t points = 0;         ///< number of valid points
  std::size_t unknown_sigmas = 0; ///< points without sigma in a view that has others
  std::optional<Pinhole> pinhole;
  std::vector<FeatureLevel> features; ///< from fine to coarse
  SurfaceBlocks surfaces;
  std::vector<AppearanceLevel> appearance; ///< empty without refinement

  std::size_t
  keypoints() const
  {
    std::size_t count = 0;
    for (const FeatureLevel& level : features)
      count += level.pixels.size();
    return count;
  }
};

/** \brief Estimates the sigmas that a view does not have.
 * \return the number of estimated points, if the view has sigmas for others, else 0 */
std::size_t
completeSigmas(CameraView& view);

/** \brief Same as \ref prepareView, without features.
 * \param[in] view must have sigmas */
EgomotionView
withoutFeatures(const CameraView& view, const EgomotionSettings& settings);

} // namespace pcl::acmap
