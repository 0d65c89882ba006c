#include "enclosed_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** Unit vectors that are spread evenly over the sphere (a Fibonacci spiral). */
std::vector<Eigen::Vector3d>
evenDirections(int number)
{
  const double golden_angle = M_PI * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < number; ++i) {
    const double z = 1 - (2 * i + 1.0) / number, radius = std::sqrt(1 - z * z);
    directions.emplace_back(
        radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i), z);
  }
  return directions;
}

} // namespace

EnclosedVolume::EnclosedVolume(const PointTree& tree)
: tree_(tree)
{
  for (std::int32_t leaf = 0; leaf < tree.leafCount(); ++leaf)
    box_.extend(tree.boxOfLeaf(leaf).cast<double>());
  middle_ = box_.center();
}

double
EnclosedVolume::ofHull() const
{
  constexpr int number = 1000;
  constexpr std::int32_t wanted = 1 << 14;
  const std::vector<Eigen::Vector3d> directions = evenDirections(number);
  std::vector<double> heights(directions.size(), 0);
  const std::int32_t stride = tree_.size() / wanted + 1;
  for (std::int32_t i = 0; i < tree_.size(); i += stride) {
    const Eigen::Vector3d point = tree_.position(i) - middle_;
    for (std::size_t d = 0; d < directions.size(); ++d)
      heights[d] = std::max(heights[d], point.dot(directions[d]));
  }
  double sum = 0;
  for (const Eigen::Vector3d& ray : directions) {
    double reach = std::numeric_limits<double>::infinity();
    for (std::size_t d = 0; d < directions.size(); ++d)
      if (const double cosine = directions[d].dot(ray); cosine > 0)
        reach = std::min(reach, heights[d] / cosine);
    sum += reach * reach * reach;
  }
  return 6 * sum * 4 * M_PI / (3 * number);
}

} // namespace pcl::acmap::ACMAP_DEWALL
