#pragma once

#include "ball_visit.h"
#include "predicates.h"
#include "size_constraint.h"

#include <array>
#include <limits>

namespace pcl::acmap::ACMAP_DEWALL {

/** \brief Returns the point p3 with the smallest circumcircle with p1 and p2, on either
 * side, under the size constraint ([P] II-C.1); -1 if there is none. */
template <typename Accept>
std::int32_t
findThirdPoint(const PointTree& tree,
               const SizeConstraint& size,
               std::int32_t p1,
               std::int32_t p2,
               const Accept& accept)
{
  const Eigen::Vector3d a = tree.position(p1), b = tree.position(p2);
  const double half = (b - a).norm() / 2;
  const double longest = std::min(size.longest(p1), size.longest(p2));
  double reach = std::sqrt(std::max(0.0, longest * longest - half * half));
  double smallest = std::numeric_limits<double>::max();
  std::int32_t best = -1;
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first; i < end; ++i) {
      const Eigen::Vector3d p = tree.position(i);
      if (i == p1 || i == p2 || !accept(i) ||
          !size.allows(p1, i, (p - a).squaredNorm()) ||
          !size.allows(p2, i, (p - b).squaredNorm()) || isDegenerate(a, b, p))
        continue;
      const double radius = smallestSphere(a, b, p).radius;
      if (radius > smallest || (radius == smallest && i > best))
        continue;
      smallest = radius;
      best = i;
      // A circle of this radius through p1 and p2 is within this distance of their
      // middle.
      reach = std::min(
          reach, radius + std::sqrt(std::max(0.0, radius * radius - half * half)));
    }
  };
  visitBall(tree, p1, 0.5 * (a + b), reach, visit);
  return best;
}

/** \brief Can three unused points be the first triangle of a component? Its smallest
 * sphere has to be empty, and for cocircular points it has to belong to the
 * triangulation that results from \ref isNearerApex; otherwise triangles from two seeds
 * could intersect. */
bool
isFirstTriangle(const PointTree& tree,
                const SizeConstraint& size,
                const std::array<std::int32_t, 3>& corners);

} // namespace pcl::acmap::ACMAP_DEWALL
