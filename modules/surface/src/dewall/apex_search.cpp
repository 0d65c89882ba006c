#include "apex_search.h"

namespace pcl::acmap::dewall {

SideFrame::SideFrame(const PointTree& tree,
                     std::int32_t a_index,
                     std::int32_t b_index,
                     std::int32_t opposite)
: a(a_index)
, b(b_index)
, origin(tree.position(a_index))
, u(tree.position(b_index) - origin)
, outward(-perpendicular(origin, tree.position(b_index), tree.position(opposite))
               .normalized())
, half_length(u.norm() / 2)
{}

LeafSieve::LeafSieve(const PointTree& tree, const SideFrame& side)
: x_(tree.coordinates(0))
, y_(tree.coordinates(1))
, z_(tree.coordinates(2))
, length_(static_cast<float>(2 * side.half_length))
{
  const Eigen::Vector3d direction = side.u / (2 * side.half_length);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    a_[i] = static_cast<float>(side.origin[axis]);
    b_[i] = static_cast<float>(side.origin[axis] + side.u[axis]);
    u_[i] = static_cast<float>(direction[axis]);
    w_[i] = static_cast<float>(side.outward[axis]);
  }
}

const float*
LeafSieve::cotangents(const PointTree::Node& leaf, double longest)
{
  constexpr float unreachable = std::numeric_limits<float>::infinity();
  const float limit2 = static_cast<float>(longest * longest * (1 + 1e-4));
  const float *x = x_ + leaf.begin, *y = y_ + leaf.begin, *z = z_ + leaf.begin;
  const auto [ax, ay, az] = a_;
  const auto [bx, by, bz] = b_;
  const auto [ux, uy, uz] = u_;
  const auto [wx, wy, wz] = w_;
  const float length = length_;
  float* __restrict cotangent = cotangent_.data();
  // Always a full leaf, so that the compiler uses its lanes: what is read beyond the
  // leaf's points is not looked at.
  for (std::int32_t k = 0; k < PointTree::leaf_capacity; ++k) {
    const float vx = x[k] - ax, vy = y[k] - ay, vz = z[k] - az;
    const float tx = x[k] - bx, ty = y[k] - by, tz = z[k] - bz;
    const float from_a2 = vx * vx + vy * vy + vz * vz;
    const float from_b2 = tx * tx + ty * ty + tz * tz;
    const float dot = vx * tx + vy * ty + vz * tz;
    const float forward = vx * wx + vy * wy + vz * wz;
    const float cx = uy * vz - uz * vy, cy = uz * vx - ux * vz, cz = ux * vy - uy * vx;
    const float value = dot / (length * std::sqrt(cx * cx + cy * cy + cz * cz));
    const float reachable = std::max(from_a2, from_b2) <= limit2 ? value : unreachable;
    cotangent[k] = forward > 0 ? reachable : unreachable;
  }
  return cotangent_.data();
}

bool
isApexAllowed(const SizeConstraint& size, const SideFrame& side, const Apex& apex)
{
  const double base = 2 * side.half_length;
  const double squared = apex.from_a.squaredNorm();
  const double other = (apex.from_a - side.u).squaredNorm();
  const double longest = std::max(base * base, std::max(squared, other));
  return apex.cross > least_sine * longest && apex.from_a.dot(side.outward) > 0 &&
         size.allows(side.a, apex.index, squared) &&
         size.allows(side.b, apex.index, other);
}

bool
isSphereEmpty(const PointTree& tree, const std::array<std::int32_t, 3>& corners)
{
  const Sphere sphere = sphereOf(tree, corners);
  const double inside = sphere.radius * (1 - sphere_tolerance);
  double radius = inside;
  const auto visit = [&](const PointTree::Node& leaf) {
    for (std::int32_t i = leaf.begin; i < leaf.end; ++i)
      if ((tree.position(i) - sphere.centre).squaredNorm() < inside * inside &&
          i != corners[0] && i != corners[1] && i != corners[2]) {
        radius = -1;
        return;
      }
  };
  tree.visitBall(
      corners[2],
      sphere.centre,
      radius,
      [](const PointTree::Node&) { return true; },
      visit);
  return radius >= 0;
}

} // namespace pcl::acmap::dewall
