#include "facing.h"

#include <cmath>

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** Consecutive points in the tree are neighbours: nearly all of them have similar
 * directions, unless the signs of the normals are random. */
bool
neighboursAgree(const LargeVector<Eigen::Vector3f>& directions)
{
  std::size_t agreeing = 0, pairs = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) {
    const float cosine = directions[i - 1].dot(directions[i]);
    agreeing += cosine > 0;
    pairs += cosine != 0;
  }
  return 2 * pairs > directions.size() && 10 * agreeing > 8 * pairs;
}

} // namespace

Eigen::Vector3f
usableNormal(const Eigen::Vector3f& normal)
{
  constexpr float tolerance = 0.1f;
  return std::abs(normal.norm() - 1) < tolerance ? normal : Eigen::Vector3f::Zero();
}

double
areaFacing(const PointTree& tree,
           const std::array<std::int32_t, 3>& corners,
           const Eigen::Vector3d& sensor)
{
  const Eigen::Vector3d a = tree.position(corners[0]);
  const Eigen::Vector3d b = tree.position(corners[1]), c = tree.position(corners[2]);
  const Eigen::Vector3d view = sensor - (a + b + c) / 3;
  const double distance = view.norm();
  return distance > 0 ? (b - a).cross(c - a).dot(view) / (2 * distance) : 0.0;
}

Facing
Facing::towards(const PointTree& tree, const Eigen::Vector3d& sensor)
{
  Facing facing;
  facing.directions_.reserve(static_cast<std::size_t>(tree.size()));
  for (std::int32_t i = 0; i < tree.size(); ++i)
    facing.directions_.push_back(
        (sensor - tree.position(i)).normalized().cast<float>());
  return facing;
}

Facing
Facing::byNormals(const PointTree& tree, const PointView& normals)
{
  Facing facing;
  if (normals.size() == 0)
    return facing;
  facing.directions_.reserve(static_cast<std::size_t>(tree.size()));
  for (std::int32_t i = 0; i < tree.size(); ++i)
    facing.directions_.push_back(
        usableNormal(normals[static_cast<std::size_t>(tree.source(i))]));
  if (!neighboursAgree(facing.directions_))
    facing.directions_.clear();
  return facing;
}

} // namespace pcl::acmap::ACMAP_DEWALL
