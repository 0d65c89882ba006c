#include "plane_input.h"

#include <pcl/core/noise_scale.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::acmap::bench {

SensorView
PlaneInput::sensors() const
{
  if (!views.empty())
    return {views.data(), sizeof(std::int32_t), origins};
  return origins.empty() ? SensorView() : SensorView(origins.front());
}

std::size_t
PlaneInput::leastSupport() const
{
  return largeCount(points->size());
}

double
toleranceFor(double sigma)
{
  constexpr double minimum = 0.002;
  return std::max(minimum, 3 * sigma);
}

PlaneInput
makePlaneInput(const PointCloud<PointXYZ>::Ptr& points,
               std::vector<Eigen::Vector3f> origins,
               std::vector<std::int32_t> views)
{
  PlaneInput input{points, std::move(origins), std::move(views)};
  const PointView view(points->points.data(), sizeof(PointXYZ), points->size());
  const NoiseScale scale = measureNoiseScale(view, input.sensors(), 1);
  input.sigma = scale.sigma;
  input.spacing = scale.spacing;
  input.tolerance = toleranceFor(scale.sigma);
  return input;
}

std::size_t
largeCount(std::size_t size)
{
  constexpr double share = 0.003;
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(size)));
}

} // namespace pcl::acmap::bench
