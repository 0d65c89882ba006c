#include "chain/egomotion_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::acmap {

namespace {

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

/** \brief Estimates the sigmas that the cloud does not have.
 * \return the number of estimated points, if the cloud has sigmas for others, else 0 */
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
  if (view.sigmas.empty())
    view.sigmas = std::move(estimated);
  for (std::size_t i = 0; i < view.points.size(); ++i)
    if (!isSigma(view.sigmas[i]))
      view.sigmas[i] = estimated[i];
  return unknown;
}

} // namespace

std::shared_ptr<const EgomotionView>
prepareView(CameraView view, const EgomotionSettings& settings)
{
  const auto prepared = std::make_shared<EgomotionView>();
  if (view.points.empty())
    return prepared;
  for (const Eigen::Vector3f& point : view.points)
    prepared->points += isPlace(point);
  prepared->pinhole = fitPinhole(view);
  prepared->unknown_sigmas = completeSigmas(view);
  const std::vector<ViewLevel> levels = viewLevels(view);
  for (std::size_t i = 0; i < std::min(levels.size(), feature_levels); ++i)
    prepared->features.push_back(featureLevel(levels[i], view, settings));
  prepared->surfaces = surfaceBlocks(view);
  if (settings.refines)
    for (std::size_t i = 1; i < levels.size(); ++i)
      prepared->appearance.push_back(appearanceLevel(levels[i]));
  return prepared;
}

} // namespace pcl::acmap
