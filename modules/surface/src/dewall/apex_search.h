#pragma once

#include "point_tree.h"
#include "predicates.h"
#include "size_constraint.h"

#include <cmath>
#include <limits>

namespace pcl::acmap::dewall {

/** \brief An open side with what the search for its next triangle needs of it. */
struct SideFrame {
  std::int32_t a, b;
  Eigen::Vector3d origin;  ///< position of a
  Eigen::Vector3d u;       ///< b - a
  Eigen::Vector3d outward; ///< unit, in the plane of its triangle, away from it
  double half_length;

  SideFrame(const PointTree& tree,
            std::int32_t a,
            std::int32_t b,
            std::int32_t opposite);
};

/** \brief What the points of one leaf are worth as apexes, in float: a sieve before the
 * exact comparison. */
class LeafSieve {
public:
  LeafSieve(const PointTree& tree, const SideFrame& side);

  /** \brief Cotangent of the angle a p b for each point, infinite where p is not in the
   * valid half-space or out of reach.
   * \param[in] longest edge allowed, metres */
  const float*
  cotangents(const PointTree::Node& leaf, double longest);

  /** \brief No point of the box lies beyond plane beta. */
  bool
  isBehind(const PointTree::Node& node) const
  {
    float most = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const float forward = ((w_[i] > 0 ? node.high[i] : node.low[i]) - a_[i]) * w_[i];
      most += forward;
      size += std::abs(forward);
    }
    return most < -1e-6f * size;
  }

private:
  const float* x_;
  const float* y_;
  const float* z_;
  std::array<float, 3> a_, b_, w_;
  std::array<float, 3> u_; ///< of unit length, so that squares stay in range
  float length_;
  std::array<float, PointTree::leaf_capacity> cotangent_;
};

/** \brief Is the apex in the valid half-space beyond plane beta and within the size
 * constraint? */
bool
isApexAllowed(const SizeConstraint& size, const SideFrame& side, const Apex& apex);

/** \brief Farthest a point may be from the middle of a side under the size constraint.
 */
inline double
reachFromMiddle(const SizeConstraint& size, const SideFrame& side)
{
  const double longest = std::min(size.longest(side.a), size.longest(side.b));
  return std::sqrt(
      std::max(0.0, longest * longest - side.half_length * side.half_length));
}

/** \brief Finds the Delaunay-nearest point over a side: the largest angle a p b in the
 * valid half-space beyond plane beta, under the size constraint ([P] II-C.1).
 *
 * \param[in] accept (index) false leaves a point out
 * \return its index, -1 where there is none */
template <typename Accept>
std::int32_t
findApex(const PointTree& tree,
         const SizeConstraint& size,
         const SideFrame& side,
         const Accept& accept)
{
  const double h = side.half_length;
  const double longest_at_side = std::min(size.longest(side.a), size.longest(side.b));
  double radius = reachFromMiddle(size, side);
  double best_cotangent = std::numeric_limits<double>::max();
  Apex best;
  LeafSieve sieve(tree, side);
  const auto consider = [&](std::int32_t i) {
    const Apex apex = makeApex(i, side.u, tree.position(i) - side.origin);
    if (!isApexAllowed(size, side, apex) ||
        (best.index >= 0 && !isNearerApex(apex, best, side.a, side.b, side.u)))
      return;
    best = apex;
    best_cotangent = apex.dot / apex.cross;
    // All better apexes lie in balls through a and b, hence within this of the middle.
    const double t = h * best_cotangent;
    radius = std::min(radius, t > 0 ? t + std::sqrt(t * t + h * h) : h);
  };
  const auto visit = [&](const PointTree::Node& leaf) {
    const float* cotangent =
        sieve.cotangents(leaf, std::min(longest_at_side, size.longestInLeaf(leaf)));
    for (std::int32_t i = leaf.begin; i < leaf.end; ++i) {
      const double margin = 1e-3 * (1 + std::abs(best_cotangent)); // of the float sieve
      if (static_cast<double>(cotangent[i - leaf.begin]) <= best_cotangent + margin &&
          i != side.a && i != side.b && accept(i))
        consider(i);
    }
  };
  const auto keep = [&](const PointTree::Node& node) { return !sieve.isBehind(node); };
  tree.visitBall(side.a, side.origin + 0.5 * side.u, radius, keep, visit);
  return best.index;
}

/** \brief The smallest sphere through three points of the tree. */
inline Sphere
sphereOf(const PointTree& tree, const std::array<std::int32_t, 3>& corners)
{
  return smallestSphere(
      tree.position(corners[0]), tree.position(corners[1]), tree.position(corners[2]));
}

/** \brief The paper's Delaunay condition: no point lies inside the smallest sphere
 * through three others, up to \ref sphere_tolerance. */
bool
isSphereEmpty(const PointTree& tree, const std::array<std::int32_t, 3>& corners);

} // namespace pcl::acmap::dewall
