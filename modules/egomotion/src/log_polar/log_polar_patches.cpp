#include "../image/smoothed_image.h"
#include "normalized_samples.h"

#include <pcl/core/impl/parallel.h>
#include <pcl/egomotion/impl/log_polar_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::acmap {

namespace {

constexpr float rounding_contrast = 1e-3F; // grey levels, above rounding errors of sums
constexpr float patch_smoothing = 1.4F;    // pixels; 1 is equally good without noise

/** A sample: four pixels and their weights. Keypoints are at pixel centres, so that the
 * weights are the same for all patches. */
struct Tap {
  std::ptrdiff_t offset = 0; ///< of the upper left pixel from the keypoint
  std::array<float, 4> weights{};
};

std::vector<Tap>
makeTaps(const LogPolarSettings& settings, int width)
{
  constexpr double turn = 6.283185307179586;
  std::vector<Tap> taps;
  for (int k = 0; k < settings.rings; ++k) {
    const double radius =
        settings.inner * std::pow(double{settings.outer} / settings.inner,
                                  double(k) / (settings.rings - 1));
    for (int m = 0; m < settings.sectors; ++m) {
      const double x = radius * std::cos(turn * m / settings.sectors);
      const double y = radius * std::sin(turn * m / settings.sectors);
      const double left = std::floor(x), up = std::floor(y);
      const auto right = static_cast<float>(x - left),
                 down = static_cast<float>(y - up);
      taps.push_back(
          {static_cast<std::ptrdiff_t>(up) * width + static_cast<std::ptrdiff_t>(left),
           {(1 - right) * (1 - down),
            right * (1 - down),
            (1 - right) * down,
            right * down}});
    }
  }
  return taps;
}

/** Computes the patches of one image. */
class PatchSampler {
public:
  PatchSampler(const GreyImage& image, const LogPolarSettings& settings)
  : image_(smoothedImage(image, patch_smoothing))
  , taps_(makeTaps(settings, image.width))
  , reach_(static_cast<int>(settings.outer) + 1)
  , min_contrast_(std::max(settings.min_contrast, rounding_contrast))
  {}

  /** \return true if there is a patch */
  bool
  sample(std::int32_t pixel, float* samples) const
  {
    const int x = pixel % image_.width, y = pixel / image_.width;
    if (x < reach_ || y < reach_ || x + reach_ >= image_.width ||
        y + reach_ >= image_.height)
      return false;
    const float* const from = image_.values.data() + pixel;
    const std::ptrdiff_t width = image_.width;
    for (std::size_t k = 0; k < taps_.size(); ++k) {
      const float* const at = from + taps_[k].offset;
      const std::array<float, 4>& weights = taps_[k].weights;
      samples[k] = weights[0] * at[0] + weights[1] * at[1] + weights[2] * at[width] +
                   weights[3] * at[width + 1];
    }
    const float contrast = normalizeSamples(samples, taps_.size()) /
                           std::sqrt(static_cast<float>(taps_.size()));
    return contrast >= min_contrast_;
  }

private:
  GreyImage image_;
  std::vector<Tap> taps_;
  int reach_;
  float min_contrast_;
};

/** Keeps the existing patches and makes them contiguous. */
void
keepPatches(const std::vector<std::uint8_t>& is_there, LogPolarPatches& patches)
{
  const std::size_t length =
      is_there.empty() ? 0 : patches.samples.size() / is_there.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < is_there.size(); ++i) {
    if (!is_there[i])
      continue;
    const auto from = patches.samples.begin() + static_cast<std::ptrdiff_t>(i * length);
    std::copy_n(from,
                length,
                patches.samples.begin() + static_cast<std::ptrdiff_t>(kept * length));
    patches.pixels[kept] = patches.pixels[i];
    patches.keypoint.push_back(static_cast<std::int32_t>(i));
    ++kept;
  }
  patches.pixels.resize(kept);
  patches.samples.resize(kept * length);
}

} // namespace

LogPolarPatches
logPolarPatches(const GreyImage& image,
                const std::vector<std::int32_t>& pixels,
                const LogPolarSettings& settings)
{
  LogPolarPatches patches;
  patches.width = image.width;
  patches.pixels = pixels;
  const auto length = static_cast<std::size_t>(settings.rings * settings.sectors);
  patches.samples.resize(pixels.size() * length);
  std::vector<std::uint8_t> is_there(pixels.size());
  withThreads(settings.threads, [&] {
    const PatchSampler sampler(image, settings);
    oneapi::tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t i) {
      is_there[i] = sampler.sample(pixels[i], &patches.samples[i * length]);
    });
  });
  keepPatches(is_there, patches);
  return patches;
}

} // namespace pcl::acmap
