#include "chain/appearance_term.h"

#include <pcl/core/impl/parallel.h>

#include <cmath>
#include <optional>

namespace pcl::acmap {

namespace {

/** \brief Interpolated value and gradient of the target. */
struct BrightnessSample {
  float value = 0;
  Eigen::Vector2f gradient;
};

/** \brief Bilinear interpolation; returns none next to the border. */
std::optional<BrightnessSample>
sampleAt(const AppearanceLevel& level, const Eigen::Vector2d& pixel)
{
  if (!(pixel.x() >= 1 && pixel.y() >= 1 && pixel.x() < level.width - 2 &&
        pixel.y() < level.height - 2))
    return std::nullopt;
  const int column = static_cast<int>(pixel.x());
  const int row = static_cast<int>(pixel.y());
  const auto s = static_cast<float>(pixel.x() - column);
  const auto t = static_cast<float>(pixel.y() - row);
  const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(level.width) +
      static_cast<std::size_t>(column);
  const std::size_t below = at + static_cast<std::size_t>(level.width);
  const auto mean = [&](const auto& values) {
    return ((1 - t) * ((1 - s) * values[at] + s * values[at + 1]) +
            t * ((1 - s) * values[below] + s * values[below + 1]));
  };
  BrightnessSample sample;
  sample.value = mean(level.values);
  sample.gradient = Eigen::Vector2f(mean(level.gradients));
  return sample;
}

/** \brief Returns true if the target sees another surface at this pixel. */
bool
isOtherSurface(const AppearanceLevel& target,
               const Eigen::Vector2d& pixel,
               double depth)
{
  constexpr double maximum = 0.05; // relative to the depth
  const std::size_t at = static_cast<std::size_t>(std::lround(pixel.y())) *
                             static_cast<std::size_t>(target.width) +
                         static_cast<std::size_t>(std::lround(pixel.x()));
  const double seen = target.points[at].z();
  return std::abs(seen - depth) > maximum * depth; // false for NaN
}

/** \brief Calls use (pixel of the source, point in the target's frame, sample). */
template <typename Use>
void
forPixels(const AppearanceLevel& source,
          const AppearanceLevel& target,
          const Pinhole& pinhole,
          const Eigen::Isometry3d& T_target_source,
          std::size_t begin,
          std::size_t end,
          const Use& use)
{
  constexpr float min_gradient = 1; // relative to the noise
  for (std::size_t i = begin; i < end; ++i) {
    if (!source.points[i].allFinite() ||
        source.gradients[i].norm() < min_gradient * source.noise)
      continue;
    const Eigen::Vector3d point = T_target_source * source.points[i].cast<double>();
    if (point.z() <= 0)
      continue;
    const Eigen::Vector2d pixel = target.fromView(pinhole.project(point));
    const std::optional<BrightnessSample> sample = sampleAt(target, pixel);
    if (sample && !isOtherSurface(target, pixel, point.z()))
      use(i, point, *sample);
  }
}

/** \brief Row of a brightness residual: the gradient of the image times the derivative
 * of the pixel with respect to the point. */
Vector6
brightnessRow(const Eigen::Vector2d& gradient,
              const Eigen::Vector2d& focal_length,
              const Eigen::Vector3d& point)
{
  const Eigen::Vector2d along = gradient.cwiseProduct(focal_length) / point.z();
  return motionRow(point,
                   {along.x(), along.y(), -along.dot(point.head<2>()) / point.z()});
}

struct BrightnessMoments {
  double count = 0, sum = 0, squares = 0;

  void
  add(double value)
  {
    count += 1;
    sum += value;
    squares += value * value;
  }

  double
  mean() const
  {
    return sum / count;
  }

  double
  variance() const
  {
    return count > 0 ? squares / count - mean() * mean() : 0;
  }
};

} // namespace

Evidence
appearanceTerm(const AppearanceLevel& source,
               const AppearanceLevel& target,
               const Pinhole& target_pinhole,
               const Eigen::Isometry3d& T_target_source,
               const LightChange& light)
{
  constexpr double misplacement = 0.2; // position error of compared pixels, pixels
  const Eigen::Vector2d focal_length =
      Eigen::Vector2d(target_pinhole.fx, target_pinhole.fy) / target.scale;
  const double noise = source.noise * source.noise +
                       light.gain * light.gain * target.noise * target.noise;
  const auto ofChunk = [&](std::size_t begin, std::size_t end) {
    Evidence evidence;
    forPixels(source,
              target,
              target_pinhole,
              T_target_source,
              begin,
              end,
              [&](std::size_t i,
                  const Eigen::Vector3d& point,
                  const BrightnessSample& sample) {
                const double residual =
                    light.gain * sample.value + light.offset - source.values[i];
                const double variance = noise + misplacement * misplacement *
                                                    source.gradients[i].squaredNorm();
                const double squared = residual * residual / variance;
                const Eigen::Vector2d gradient =
                    light.gain * sample.gradient.cast<double>();
                evidence.add(tileOf(target_pinhole, point),
                             brightnessRow(gradient, focal_length, point),
                             residual,
                             robustWeight(squared) / variance);
                evidence.tell(squared);
              });
    return evidence;
  };
  return parallelReduceChunks(
      source.values.size(),
      Evidence{},
      ofChunk,
      [](Evidence& sum, const Evidence& part) { sum.add(part); });
}

LightChange
lightChange(const AppearanceLevel& source,
            const AppearanceLevel& target,
            const Pinhole& target_pinhole,
            const Eigen::Isometry3d& T_target_source)
{
  BrightnessMoments now, before;
  forPixels(source,
            target,
            target_pinhole,
            T_target_source,
            0,
            source.values.size(),
            [&](std::size_t i, const Eigen::Vector3d&, const BrightnessSample& sample) {
              now.add(source.values[i]);
              before.add(sample.value);
            });
  LightChange light;
  if (now.variance() > 0 && before.variance() > 0) {
    light.gain = std::sqrt(now.variance() / before.variance());
    light.offset = now.mean() - light.gain * before.mean();
  }
  return light;
}

} // namespace pcl::acmap
