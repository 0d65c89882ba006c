#include "noise/base_edge.h"

#include "noise/point_sample.h"

#include <pcl/core/voxel_moments.h>

#include <cmath>
#include <limits>
#include <vector>

namespace pcl::acmap {

namespace {

std::vector<Eigen::Vector3f>
sampleOf(const PointView& points)
{
  constexpr std::size_t wanted = 1 << 12;
  const PointSample chosen(points.size(), wanted);
  std::vector<Eigen::Vector3f> sample;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite() && chosen.holds(points[i]))
      sample.push_back(points[i]);
  return sample;
}

double
extentOf(const std::vector<Eigen::Vector3f>& sample)
{
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (const Eigen::Vector3f& point : sample)
      values.push_back(point[axis]);
    const auto tenth = static_cast<std::ptrdiff_t>(values.size() / 10);
    std::nth_element(values.begin(), values.begin() + tenth, values.end());
    const double least = values[static_cast<std::size_t>(tenth)];
    std::nth_element(values.begin(), values.end() - 1 - tenth, values.end());
    extent = std::max(extent, *(values.end() - 1 - tenth) - least);
  }
  return extent;
}

} // namespace

double
edgeForOccupancy(const PointView& points, double occupancy)
{
  const std::vector<Eigen::Vector3f> sample = sampleOf(points);
  if (sample.empty())
    return 0;
  double edge = extentOf(sample);
  if (!(edge > 0))
    return 0;
  const PointView view(sample.data(), sizeof(Eigen::Vector3f), sample.size());
  // If a voxel contains four points of the sample, the voxels are occupied as by a
  // surface.
  constexpr double filled = 4;
  double held = 0;
  for (int halving = 0; halving < 40; ++halving) {
    const std::size_t cells = sumVoxels(view, SensorView(), edge, 1).cells.size();
    held = static_cast<double>(sample.size()) /
           static_cast<double>(std::max<std::size_t>(cells, 1));
    if (held <= filled)
      break;
    edge /= 2;
  }
  const double all =
      held * static_cast<double>(points.size()) / static_cast<double>(sample.size());
  return edge * std::sqrt(occupancy / all);
}

} // namespace pcl::acmap
