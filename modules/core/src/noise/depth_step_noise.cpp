#include "noise/depth_step_noise.h"

#include <pcl/core/depth_view.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::acmap {

namespace {

/** Noise if the pixels are unknown: that of the quantisation, assuming that the step of
 * a sensor is about twice its own noise. */
NoiseScale::InverseDepth
noiseOfStep(double step)
{
  NoiseScale::InverseDepth noise;
  noise.step = step;
  noise.independent = step / std::sqrt(12.0);
  noise.correlated = step / 2;
  return noise;
}

/** Counts points in bins of a factor of sqrt (2), as for other clouds. */
std::map<int, std::size_t>
countRanges(const PointView& points, std::vector<double>& depths)
{
  std::map<int, std::size_t> bins;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = points[i];
    if (!point.allFinite() || !(point.z() > 0))
      continue;
    const double depth = static_cast<double>(point.z());
    depths.push_back(depth);
    ++bins[static_cast<int>(std::floor(2 * std::log2(depth)))];
  }
  return bins;
}

} // namespace

void
applyDepthSteps(const PointView& points, std::size_t width, NoiseScale& scale)
{
  const double step = measureDepthStep(points);
  if (step == 0)
    return;
  NoiseScale::InverseDepth noise = noiseOfStep(step);
  if (width > 0)
    if (const std::optional<DepthView> view = DepthView::recognize(points, width))
      noise = measureInverseDepthNoise(*view, step);
  std::vector<double> depths;
  const std::map<int, std::size_t> bins = countRanges(points, depths);
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  scale.inverse_depth = noise;
  scale.sigma = std::max(scale.sigma, noise.sigma() * *middle * *middle);
  constexpr std::size_t enough = 100;
  scale.ranges.clear();
  for (const auto& [bin, number] : bins) {
    const double distance = std::exp2((bin + 0.5) / 2);
    if (number >= enough)
      scale.ranges.push_back({distance, noise.sigma() * distance * distance, number});
  }
  scale.remarks.clear(); // quantisation steps look like shapes
  char text[96];
  std::snprintf(text,
                sizeof text,
                "the depth is quantised: steps of %.2g mm at 1 m, %.3g mm at 4 m",
                1000 * step,
                16000 * step);
  scale.remarks.emplace_back(text);
}

} // namespace pcl::acmap
