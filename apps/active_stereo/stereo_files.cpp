#include "stereo_files.h"

#include "output_target.h"

#include <pcl/conversions.h>
#include <pcl/core/disparity_image.h>
#include <pcl/core/image_file.h>
#include <pcl/pipeline/observation_files.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::acmap {

namespace {

constexpr float darkest = 64; // clearly distinct from black
constexpr float brightest = 255;
constexpr float min_range = 1e-6F;         // px
constexpr std::size_t cut_at_an_end = 100; // fraction 1 / 100

/** \brief Draws disparities as a grey picture, 8 bits per pixel: near is bright (64 to
 * 255), black (0) means invalid. The grey levels span the disparities without the
 * lowest and highest 1 %. */
std::vector<std::uint8_t>
pictureOf(const DisparityImage& disparities)
{
  std::vector<std::uint8_t> greys(disparities.values.size(), 0);
  std::vector<float> found;
  for (const float disparity : disparities.values)
    if (std::isfinite(disparity))
      found.push_back(disparity);
  if (found.empty())
    return greys;
  std::sort(found.begin(), found.end());
  const std::size_t cut = found.size() / cut_at_an_end;
  const float least = found[cut];
  const float most = found[found.size() - 1 - cut];
  const float range = std::max(most - least, min_range);
  for (std::size_t i = 0; i < greys.size(); ++i) {
    const float disparity = disparities.values[i];
    if (!std::isfinite(disparity))
      continue;
    const float share = std::clamp((disparity - least) / range, 0.0F, 1.0F);
    greys[i] =
        static_cast<std::uint8_t>(std::lround(darkest + share * (brightest - darkest)));
  }
  return greys;
}

constexpr const char* disparity_name = "disparity";

bool
isStereoName(const std::string& name)
{
  return isSequenceName(name) || name.rfind(disparity_name, 0) == 0;
}

} // namespace

void
requireNoStereo(const OutputFolder& folder)
{
  requireNoneIn(folder, isStereoName);
}

void
saveResults(const OutputFolder& folder,
            const StereoOptions& options,
            const ObservationShots& shots,
            const MadeObservation& made,
            const Eigen::Isometry3d& T_map_camera)
{
  PCLPointCloud2 cloud;
  toPCLPointCloud2(made.cloud, cloud);
  saveObservation(folder.path(observationName(shots.number)), cloud, T_map_camera);
  if (!options.hasLists() && !options.disparity)
    return;
  const auto path = [&](const char* ending) {
    return folder.path(options.hasLists()
                           ? std::string(disparity_name) + ending
                           : numberedName(disparity_name, shots.number, ending));
  };
  const DisparityImage& disparity = made.matched.disparity;
  savePfm(path(".pfm"), disparity);
  savePng(path(".png"), disparity.width, disparity.height, pictureOf(disparity));
}

} // namespace pcl::acmap
