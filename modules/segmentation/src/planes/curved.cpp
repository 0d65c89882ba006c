#include "planes/curved.h"

#include "planes/interior.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl::acmap::planes {
namespace {

/** Root mean square of that part of the distances from the plane that is explained by
 * bending, i.e. by the quadratic terms without offset and slopes. */
double
bend(const CellGraph& graph,
     const std::vector<std::int32_t>& members,
     const Plane& plane)
{
  using Terms = Eigen::Matrix<double, 6, 1>;
  const Eigen::Vector3d u = plane.normal.unitOrthogonal();
  const Eigen::Vector3d v = plane.normal.cross(u);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const std::int32_t member : members)
    middle += graph.points[static_cast<std::size_t>(member)];
  middle /= static_cast<double>(members.size());
  double extent = 0;
  for (const std::int32_t member : members)
    extent = std::max(extent,
                      (graph.points[static_cast<std::size_t>(member)] - middle).norm());
  if (!(extent > 0))
    return 0;

  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right = Terms::Zero();
  for (const std::int32_t member : members) {
    const Eigen::Vector3d& point = graph.points[static_cast<std::size_t>(member)];
    const double a = (point - middle).dot(u) / extent;
    const double b = (point - middle).dot(v) / extent;
    Terms terms;
    terms << 1, a, b, a * a, a * b, b * b;
    normal_matrix += terms * terms.transpose();
    right += plane.distance(point) * terms;
  }
  const Terms fit = normal_matrix.ldlt().solve(right);
  // Reduction of the sum of squares by the full fit, minus that by offset and slopes
  // only.
  const Eigen::Vector3d linear = normal_matrix.topLeftCorner<3, 3>().ldlt().solve(
      Eigen::Vector3d(right.head<3>()));
  const double explained = fit.dot(right) - linear.dot(right.head<3>());
  return std::sqrt(std::max(explained, 0.0) / static_cast<double>(members.size()));
}

/** Continuation of the surface beyond the rim of a region, as fractions of its rim. */
struct Surroundings {
  double smooth = 0; ///< smooth, but off the plane
  double curved = 0; ///< smooth, and known to be curved there
};

Surroundings
surroundingsOf(const CellGraph& graph,
               const std::vector<std::int32_t>& members,
               const std::vector<std::int32_t>& owner,
               const PlaneRegion& region,
               double cosine)
{
  const Plane& plane = region.plane();
  std::size_t rim = 0, smooth = 0, curved = 0;
  for (const std::int32_t member : members) {
    const auto m = static_cast<std::size_t>(member);
    bool is_rim = false, is_smooth = false, is_curved = false;
    for (const std::int32_t other : graph.neighbours[m]) {
      const auto o = static_cast<std::size_t>(other);
      if (owner[o] == owner[m])
        continue;
      is_rim = true;
      if (graph.normals[o].dot(graph.normals[m]) <= cosine ||
          graph.normals[o].cast<double>().dot(plane.normal) <= cosine ||
          std::abs(plane.distance(graph.points[o])) >= 3 * region.distance())
        continue;
      is_smooth = true;
      is_curved |= owner[o] == curved_surface;
    }
    rim += is_rim ? 1 : 0;
    smooth += is_smooth ? 1 : 0;
    curved += is_curved ? 1 : 0;
  }
  const double all = static_cast<double>(std::max<std::size_t>(rim, 1));
  return {static_cast<double>(smooth) / all, static_cast<double>(curved) / all};
}

} // namespace

bool
isCurved(const CellGraph& graph,
         const std::vector<std::int32_t>& members,
         const std::vector<std::int32_t>& owner,
         const PlaneRegion& region,
         double cosine)
{
  constexpr double min_curved = 0.35; // of the rim
  const Surroundings around = surroundingsOf(graph, members, owner, region, cosine);
  if (around.curved > min_curved)
    return true; // the rest of a curved surface is too narrow to bend
  const std::vector<std::int32_t> inner = interior(graph, members, owner);
  constexpr std::size_t min_inner = 12;
  if (inner.size() < min_inner)
    return false;
  // A parabola that just stays within the limits has a bend of 0.45 times the limit,
  // and less if the region is only a few points wide; then more of its rim has to be
  // smooth.
  const double bent = bend(graph, inner, region.plane()) / region.distance();
  return (bent > 0.25 && around.smooth > 0.35) || (bent > 0.15 && around.smooth > 0.8);
}

} // namespace pcl::acmap::planes
