#include "noise_truth.h"

#include "statistics.h"

#include <cmath>
#include <unordered_map>

namespace pcl::acmap::bench {
namespace {

struct SquareSum {
  std::size_t count = 0;
  double sum = 0;

  void
  add(double value)
  {
    ++count;
    sum += value * value;
  }

  double
  root() const
  {
    return std::sqrt(sum / static_cast<double>(count));
  }
};

std::uint64_t
cellKey(const TruthPlane& plane,
        std::uint32_t label,
        const Eigen::Vector3d& point,
        double edge)
{
  constexpr double middle = 1 << 23; // keeps both indices positive
  const SimulatedRectangle& rectangle = plane.rectangles.front();
  const Eigen::Vector3d offset = point - rectangle.corner;
  const double u = std::floor(offset.dot(rectangle.edge_u.normalized()) / edge);
  const double v = std::floor(offset.dot(rectangle.edge_v.normalized()) / edge);
  return std::uint64_t{label} << 48 | static_cast<std::uint64_t>(u + middle) << 24 |
         static_cast<std::uint64_t>(v + middle);
}

double
medianOfCells(const std::unordered_map<std::uint64_t, SquareSum>& cells)
{
  constexpr std::size_t min_points = 9;
  std::vector<double> deviations;
  for (const auto& [key, cell] : cells)
    if (cell.count >= min_points)
      deviations.push_back(cell.root());
  return median(deviations);
}

} // namespace

int
rangeBin(double distance)
{
  return static_cast<int>(std::floor(2 * std::log2(distance)));
}

NoiseTruth
measureTruth(const SimulatedCloud& cloud, double visible_area)
{
  constexpr double min_edge = 0.1;
  constexpr double points_of_an_edge = 4;
  NoiseTruth truth;
  truth.spacing = std::sqrt(visible_area / static_cast<double>(cloud.size()));
  const double edge = std::max(min_edge, points_of_an_edge * truth.spacing);
  std::unordered_map<std::uint64_t, SquareSum> cells;
  std::map<int, SquareSum> ranges;
  const std::vector<Eigen::Vector3f> origins = cloud.sensorOrigins();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t label = cloud.merged.label[i];
    if (label == 0)
      continue;
    const TruthPlane& plane = cloud.merged.planes[label - 1];
    const Eigen::Vector3d normal = plane.coefficients.head<3>();
    const Eigen::Vector3d point = cloud.merged.points[i].cast<double>();
    const double height = normal.dot(point) + plane.coefficients[3];
    cells[cellKey(plane, label, point, edge)].add(height);
    const auto view = static_cast<std::size_t>(cloud.merged.view[i]);
    const Eigen::Vector3d ray = point - origins[view].cast<double>();
    ranges[rangeBin(ray.norm())].add(height / normal.dot(ray.normalized()));
  }
  truth.sigma = medianOfCells(cells);
  for (const auto& [bin, sum] : ranges)
    truth.ranges[bin] = sum.root();
  return truth;
}

} // namespace pcl::acmap::bench
