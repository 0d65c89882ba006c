#include "planes/curved.h"

#include "planes/interior.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl::acmap::planes {
namespace {

/** Root mean square of what a bend explains of the distances from the plane: the quadratic
 * terms, free of offset and slopes. */
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
  // what the fit lowers the sum of squares by, less what offset and slopes alone would
  const Eigen::Vector3d linear = normal_matrix.topLeftCorner<3, 3>().ldlt().solve(
      Eigen::Vector3d(right.head<3>()));
  const double explained = fit.dot(right) - linear.dot(right.head<3>());
  return std::sqrt(std::max(explained, 0.0) / static_cast<double>(members.size()));
}

/** How the surface goes on beyond the rim of a region, as shares of its rim. */
struct Surroundings {
  double smooth = 0; ///< smoothly, but off the plane
  double curved = 0; ///< smoothly, and there it is known to be curved
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
  constexpr double least_curved = 0.35; // of the rim
  const Surroundings around = surroundingsOf(graph, members, owner, region, cosine);
  if (around.curved > least_curved)
    return true; // what others left of a curved surface is too narrow to bend
  const std::vector<std::int32_t> inner = interior(graph, members, owner);
  constexpr std::size_t least_inner = 12;
  if (inner.size() < least_inner)
    return false;
  // a parabola that just stays within the limits has a bend of 0.45 of them, and less
  // where the region is but a few points wide; then all its rim has to tell the same
  const double bent = bend(graph, inner, region.plane()) / region.distance();
  return (bent > 0.25 && around.smooth > 0.35) || (bent > 0.15 && around.smooth > 0.8);
}

} // namespace pcl::acmap::planes
