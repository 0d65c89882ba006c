#include <pcl/simulation/simulated_observation.h>

#include "depth_measurement.h"
#include "mixed_bits.h"

#include <pcl/core/parallel.h>
#include <pcl/simulation/surface_color.h>

#include <algorithm>
#include <limits>

namespace pcl {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint64_t not_in_reach = std::numeric_limits<std::uint64_t>::max();

/** \brief Measurement of one view. */
class Measurement {
public:
  Measurement(const SimulatedScene& scene,
              const SurfaceImage& image,
              std::size_t view,
              std::uint64_t seed)
  : scene_(scene)
  , image_(image)
  , T_scene_camera_(scene.views[view])
  , points_(scene.sensor.pointsOfView(view))
  , stream_(acmap::mixedBits(seed, view))
  {}

  SimulatedObservation
  run() const
  {
    SimulatedObservation observation;
    observation.width = image_.width;
    observation.height = image_.height;
    observation.pixels.resize(image_.distance.size());
    const std::vector<std::uint64_t> keys = drawKeys();
    const std::uint64_t bound = boundOfKept(keys, observation);
    acmap::parallelForChunks(keys.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t pixel = begin; pixel < end; ++pixel)
        observation.pixels[pixel] = measure(pixel, keys[pixel] < bound);
    });
    return observation;
  }

private:
  acmap::Random
  streamOf(std::size_t pixel) const
  {
    return acmap::Random(acmap::mixedBits(stream_, pixel));
  }

  Eigen::Vector3d
  rayOf(std::size_t pixel) const
  {
    const auto width = static_cast<std::size_t>(image_.width);
    return pixelRay(
        scene_.rig, static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  }

  /** \brief A random key for each pixel in reach, with the pixel index in the lower
   * bits, so that all keys are different. The pixels with the smallest keys are
   * chosen. */
  std::vector<std::uint64_t>
  drawKeys() const
  {
    constexpr std::uint64_t low_half = 0xffffffffu;
    std::vector<std::uint64_t> keys(image_.distance.size(), not_in_reach);
    acmap::parallelForChunks(keys.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t pixel = begin; pixel < end; ++pixel)
        if (image_.distance[pixel] * rayOf(pixel).z() <= scene_.sensor.reach)
          keys[pixel] = (streamOf(pixel).bits() & ~low_half) | pixel;
    });
    return keys;
  }

  /** \brief Upper bound of the keys of the chosen pixels, exclusive. */
  std::uint64_t
  boundOfKept(const std::vector<std::uint64_t>& keys,
              SimulatedObservation& observation) const
  {
    std::vector<std::uint64_t> in_reach;
    in_reach.reserve(keys.size());
    std::copy_if(keys.begin(),
                 keys.end(),
                 std::back_inserter(in_reach),
                 [](std::uint64_t key) { return key != not_in_reach; });
    observation.in_reach = in_reach.size();
    observation.points = std::min(points_, in_reach.size());
    if (observation.points == in_reach.size())
      return not_in_reach;
    if (observation.points == 0)
      return 0;
    const auto last =
        in_reach.begin() + static_cast<std::ptrdiff_t>(observation.points) - 1;
    std::nth_element(in_reach.begin(), last, in_reach.end());
    return *last + 1;
  }

  ObservationPixel
  measure(std::size_t pixel, bool kept) const
  {
    ObservationPixel measured{nan, nan, nan, 0, nan, 0};
    const std::int32_t index = image_.surface[pixel];
    if (index < 0)
      return measured;
    const auto& surface = scene_.geometry.surfaces()[static_cast<std::size_t>(index)];
    const double distance = image_.distance[pixel];
    const Eigen::Vector3d ray = rayOf(pixel);
    const auto color = surfaceColor(
        surface, static_cast<std::size_t>(index), T_scene_camera_ * (distance * ray));
    measured.rgb = std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 |
                   std::uint32_t{color[2]};
    if (!kept)
      return measured;
    acmap::Random random = streamOf(pixel);
    random.bits(); // these bits were used for the key
    const double sigma = scene_.sensor.sigma(distance * ray.z());
    const Eigen::Vector3f point =
        ((distance + sigma * random.normal()) * ray).cast<float>();
    measured.x = point.x();
    measured.y = point.y();
    measured.z = point.z();
    measured.sigma = static_cast<float>(sigma);
    measured.label = static_cast<std::uint32_t>(surface.plane + 1);
    return measured;
  }

  const SimulatedScene& scene_;
  const SurfaceImage& image_;
  const Eigen::Isometry3d& T_scene_camera_;
  std::size_t points_;
  std::uint64_t stream_;
};

} // namespace

SimulatedObservation
observe(const SimulatedScene& scene,
        const SurfaceImage& image,
        std::size_t view,
        std::uint64_t seed)
{
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (view >= scene.views.size() || image.width != scene.rig.width ||
      image.height != scene.rig.height || image.distance.size() != pixels ||
      image.surface.size() != pixels)
    throw BadArgumentException("the image is none of view " + std::to_string(view) +
                               " of scene '" + scene.name + "'");
  if (scene.depth_camera)
    return acmap::measureDepths(scene, image, view, seed);
  return Measurement(scene, image, view, seed).run();
}

SimulatedObservation
observe(const SimulatedScene& scene, std::size_t view, std::uint64_t seed)
{
  if (view >= scene.views.size())
    throw BadArgumentException("scene '" + scene.name + "' has no view " +
                               std::to_string(view));
  const SurfaceImage image = castView(scene.geometry, scene.rig, scene.views[view]);
  return observe(scene, image, view, seed);
}

} // namespace pcl
