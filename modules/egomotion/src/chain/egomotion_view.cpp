#include "chain/egomotion_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

// Relative to the noise of a value, of which a fifth remains in patches and gradients
// after smoothing.
constexpr float min_gradient = 1, min_contrast = 1;

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

constexpr std::size_t feature_levels = 3;

bool
isPlace(const Eigen::Vector3f& point)
{
  return point.allFinite() && point.z() > 0;
}

bool
isSigma(float sigma)
{
  return sigma > 0 && std::isfinite(sigma);
}

std::size_t
countPlaces(const CameraView& view)
{
  return static_cast<std::size_t>(
      std::count_if(view.points.begin(), view.points.end(), isPlace));
}

std::optional<Pinhole>
pinholeOf(const CameraView& view)
{
  return fitUprightPinhole(
      {view.points.data(), sizeof view.points[0], view.points.size()},
      static_cast<std::size_t>(view.image.width));
}

/** \brief Surfaces and brightness of a view. */
void
addScene(const CameraView& view,
         const std::vector<ViewLevel>& levels,
         const EgomotionSettings& settings,
         EgomotionView& prepared)
{
  prepared.surfaces = surfaceBlocks(view);
  if (settings.refines)
    for (std::size_t i = 1; i < levels.size(); ++i)
      prepared.appearance.push_back(appearanceLevel(levels[i]));
}

} // namespace

std::size_t
completeSigmas(CameraView& view)
{
  std::size_t unknown = 0;
  if (!view.sigmas.empty())
    for (std::size_t i = 0; i < view.points.size(); ++i)
      unknown += isPlace(view.points[i]) && !isSigma(view.sigmas[i]);
  if (!view.sigmas.empty() && unknown == 0)
    return 0;
  std::vector<float> estimated = estimatedSigmas(view);
  if (view.sigmas.empty()) {
    view.sigmas = std::move(estimated);
    return 0;
  }
  for (std::size_t i = 0; i < view.points.size(); ++i)
    if (!isSigma(view.sigmas[i]))
      view.sigmas[i] = estimated[i];
  return unknown;
}

EgomotionView
withoutFeatures(const CameraView& view, const EgomotionSettings& settings)
{
  EgomotionView prepared;
  if (view.points.empty())
    return prepared;
  prepared.points = countPlaces(view);
  prepared.pinhole = pinholeOf(view);
  addScene(view, viewLevels(view), settings, prepared);
  return prepared;
}

std::shared_ptr<const EgomotionView>
prepareView(CameraView view, const EgomotionSettings& settings)
{
  const auto prepared = std::make_shared<EgomotionView>();
  if (view.points.empty())
    return prepared;
  prepared->points = countPlaces(view);
  prepared->pinhole = pinholeOf(view);
  if (settings.paper) {
    view.sigmas.assign(view.points.size(), 0); // Eq. 2 has no weights
    const ViewLevel full{view.image, view.points, 0, 1};
    prepared->features.push_back(featureLevel(full, view, settings));
    return prepared;
  }
  prepared->unknown_sigmas = completeSigmas(view);
  const std::vector<ViewLevel> levels = viewLevels(view);
  for (std::size_t i = 0; i < std::min(levels.size(), feature_levels); ++i)
    prepared->features.push_back(featureLevel(levels[i], view, settings));
  addScene(view, levels, settings, *prepared);
  return prepared;
}

} // namespace pcl::acmap
