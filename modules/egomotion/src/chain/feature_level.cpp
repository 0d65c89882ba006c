#include "chain/feature_level.h"

namespace pcl::acmap {

namespace {

// Relative to the noise of a value, of which a fifth remains in patches and gradients
// after smoothing.
constexpr float min_gradient = 1, min_contrast = 1;

} // namespace

FeatureLevel
featureLevel(const ViewLevel& level,
             const CameraView& view,
             const EgomotionSettings& settings)
{
  KeypointSettings keypoint_settings = settings.keypoints;
  keypoint_settings.threads = settings.threads;
  keypoint_settings.min_gradient = min_gradient * level.noise;
  LogPolarSettings patch_settings = settings.patches;
  patch_settings.threads = settings.threads;
  patch_settings.min_contrast = min_contrast * level.noise;
  std::vector<std::uint8_t> has_place;
  has_place.reserve(level.points.size());
  for (const Eigen::Vector3f& point : level.points)
    has_place.push_back(point.z() > 0);
  KeypointCounts counts;
  const std::vector<std::int32_t> keypoints =
      gradientMaxima(level.image, has_place, keypoint_settings, counts);
  FeatureLevel features;
  features.scale = level.scale;
  for (const std::int32_t keypoint : keypoints) {
    const std::size_t pixel = level.viewPixel(keypoint, view.image.width);
    features.pixels.push_back(static_cast<std::int32_t>(pixel));
    features.places.push_back(level.points[static_cast<std::size_t>(keypoint)]);
    features.sigmas.push_back(view.sigmas[pixel]);
  }
  features.patches = logPolarPatches(level.image, keypoints, patch_settings);
  return features;
}

} // namespace pcl::acmap
