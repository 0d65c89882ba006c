#include "third_point.h"

#include "apex_search.h"
#include "ball_visit.h"

namespace pcl::acmap::ACMAP_DEWALL {

namespace {

/** \brief Points on the sphere, without its three corners. */
std::vector<std::int32_t>
pointsOnSphere(const PointTree& tree,
               const Sphere& sphere,
               const std::array<std::int32_t, 3>& corners)
{
  std::vector<std::int32_t> result;
  const double reach = sphere.radius * (1 + sphere_tolerance);
  const auto visit = [&](std::int32_t, std::int32_t first, std::int32_t end) {
    for (std::int32_t i = first; i < end; ++i)
      if ((tree.position(i) - sphere.centre).norm() <= reach && i != corners[0] &&
          i != corners[1] && i != corners[2])
        result.push_back(i);
  };
  visitBall(tree, corners[0], sphere.centre, reach, visit);
  return result;
}

/** \brief Is point q, on the same side of a b as c, preferred to c as the apex? */
bool
comesBefore(const PointTree& tree,
            const SizeConstraint& size,
            std::int32_t q,
            std::int32_t a,
            std::int32_t b,
            std::int32_t c)
{
  const Eigen::Vector3d origin = tree.position(a), end = tree.position(b);
  const Eigen::Vector3d u = end - origin, from_a = tree.position(q) - origin;
  if (!size.allows(a, q, from_a.squaredNorm()) ||
      !size.allows(b, q, (from_a - u).squaredNorm()) ||
      cosineOfTurn(origin, end, tree.position(q), tree.position(c)) > 0)
    return false;
  return isNearerApex(
      makeApex(q, u, from_a), makeApex(c, u, tree.position(c) - origin), a, b, u);
}

} // namespace

bool
isFirstTriangle(const PointTree& tree,
                const SizeConstraint& size,
                const std::array<std::int32_t, 3>& corners)
{
  const auto [a, b, c] = corners;
  if (!isSphereEmpty(tree, corners))
    return false;
  for (const std::int32_t q : pointsOnSphere(tree, sphereOf(tree, corners), corners))
    if (comesBefore(tree, size, q, a, b, c) || comesBefore(tree, size, q, b, c, a) ||
        comesBefore(tree, size, q, c, a, b))
      return false;
  return true;
}

} // namespace pcl::acmap::ACMAP_DEWALL
