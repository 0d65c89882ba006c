#include "naive_growth.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {
namespace {

/** Finds all supporters of the plane of a seed, one by one. */
NaivePlane
growFrom(const NaiveHypotheses& all,
         std::size_t seed,
         const NaiveThresholds& limits,
         const std::vector<bool>& is_used)
{
  NaivePlane plane{all.normals[seed], 0, {static_cast<std::int32_t>(seed)}};
  plane.offset = -plane.normal.dot(all.points[seed]);
  std::vector<bool> is_member(all.points.size(), false);
  is_member[seed] = true;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::size_t j = 0; j < all.points.size(); ++j) {
      if (is_used[j] || is_member[j] || !supports(all, j, plane, limits) ||
          !isNearSome(all, j, plane, limits))
        continue;
      is_member[j] = has_grown = true;
      plane.members.push_back(static_cast<std::int32_t>(j));
      constexpr std::size_t enough = 12; // for fewer points, the seed's own normal is
                                         // more accurate
      if (plane.members.size() >= enough)
        plane = planeThrough(all, plane.members, plane.normal);
    }
  }
  return plane;
}

} // namespace

bool
supports(const NaiveHypotheses& all,
         std::size_t point,
         const NaivePlane& plane,
         const NaiveThresholds& limits)
{
  return all.normals[point].dot(plane.normal) > limits.cosine &&
         std::abs(plane.normal.dot(all.points[point]) + plane.offset) <
             limits.plane_distance;
}

bool
isNearSome(const NaiveHypotheses& all,
           std::size_t point,
           const NaivePlane& plane,
           const NaiveThresholds& limits)
{
  return std::any_of(
      plane.members.begin(), plane.members.end(), [&](std::int32_t member) {
        const auto m = static_cast<std::size_t>(member);
        return m != point &&
               (all.points[m] - all.points[point]).norm() < limits.member_distance;
      });
}

NaivePlane
planeThrough(const NaiveHypotheses& all,
             const std::vector<std::int32_t>& members,
             const Eigen::Vector3d& front)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::int32_t member : members)
    mean += all.points[static_cast<std::size_t>(member)];
  mean /= static_cast<double>(members.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const std::int32_t member : members) {
    const Eigen::Vector3d off = all.points[static_cast<std::size_t>(member)] - mean;
    scatter += off * off.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  NaivePlane plane{solver.eigenvectors().col(0), 0, members};
  if (plane.normal.dot(front) < 0)
    plane.normal = -plane.normal;
  plane.offset = -plane.normal.dot(mean);
  return plane;
}

std::vector<NaivePlane>
growNaively(const NaiveHypotheses& all, const NaiveThresholds& limits)
{
  std::vector<bool> is_used(all.points.size(), false);
  std::vector<NaivePlane> planes;
  for (std::size_t seed = 0; seed < all.points.size(); ++seed) {
    if (is_used[seed])
      continue;
    NaivePlane plane = growFrom(all, seed, limits, is_used);
    if (plane.members.size() <= limits.support)
      continue;
    std::sort(plane.members.begin(), plane.members.end());
    for (const std::int32_t member : plane.members)
      is_used[static_cast<std::size_t>(member)] = true;
    planes.push_back(std::move(plane));
  }
  return planes;
}

} // namespace pcl::acmap::test
