#include "planes/plane_growth.h"

#include "mesh_neighbourhood.h"
#include "planes/cell_graph.h"
#include "planes/plane_region.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::planes {

namespace {

/** Returns the members whose mesh neighbours are all in the same region: they are
 * neither at its rim nor in a strip that is too narrow to define a plane. */
std::vector<std::int32_t>
interior(const CellGraph& graph,
         const std::vector<std::int32_t>& members,
         const std::vector<std::int32_t>& owner)
{
  std::vector<std::int32_t> inner;
  for (const std::int32_t member : members) {
    const auto m = static_cast<std::size_t>(member);
    bool is_inner = graph.neighbours[m].size() > 0;
    for (const std::int32_t other : graph.neighbours[m])
      is_inner &= owner[static_cast<std::size_t>(other)] == owner[m];
    if (is_inner)
      inner.push_back(member);
  }
  return inner;
}

/** Owner of hypotheses on curved surfaces. */
inline constexpr std::int32_t curved_surface = -2;

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

/** Is the region a part of a curved surface? It is if it bends by as much as its limits
 * permit, and ends where the surface continues beyond them. */
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
  const double bending = bend(graph, inner, region.plane());
  // A floor with drift bends, too, but over its whole width.
  constexpr double of_floors = 0.0015, squared_width = 12; // of the variance
  const double variance = fitPlane(region.moments()).variances[1];
  if (bending < of_floors * std::sqrt(squared_width * variance))
    return false;
  const double bent = bending / region.distance();
  return (bent > 0.25 && around.smooth > 0.35) || (bent > 0.15 && around.smooth > 0.8);
}

using Members = std::vector<std::int32_t>;

/** State of one run: the owner of each hypothesis, and the planes so far. */
class NoiseDrivenGrowth {
public:
  NoiseDrivenGrowth(const CellGraph& graph,
                    double min_area,
                    PlaneClusteringReport& report)
  : graph_(graph)
  , neighbours_(graph.neighbours)
  , min_area_(min_area)
  , report_(report)
  , owner_(graph.size(), no_region)
  {}

  void
  growLarge(const std::vector<std::int32_t>& seeds, const PlaneLimits& limits)
  {
    grow(seeds, limits, [&](const Members& members, const PlaneRegion& region) {
      const double area = graph_.areaOf(members);
      if (area < min_area_ || isNarrow(region.moments(), graph_.spacing))
        return false;
      return isBent(members, region, limits) ||
             keep(members, region, area, PlaneTrust::Sure);
    });
  }

  void
  growRest(const std::vector<std::int32_t>& seeds, const PlaneLimits& limits)
  {
    grow(seeds, limits, [&](const Members& members, const PlaneRegion& region) {
      constexpr std::size_t min_members = 8;
      if (members.size() < min_members || graph_.areaOf(members) < graph_.least_area) {
        ++report_.small_regions;
        return false;
      }
      const bool is_narrow = isNarrow(region.moments(), graph_.spacing);
      return isBent(members, region, limits) ||
             keep(members,
                  region,
                  graph_.areaOf(members),
                  is_narrow ? PlaneTrust::Strip : PlaneTrust::Small);
    });
  }

  /** Warped walls and misregistered clouds deviate by more than noise. Such a wall ends
   * at its own edges if the band is wide enough, unlike a curved surface, which
   * continues smoothly beyond any band. */
  void
  growWarped(const std::vector<std::int32_t>& seeds, PlaneLimits limits)
  {
    constexpr double widening = 1.4142;
    is_wide_ = true;
    while (report_.curved_regions > 0 && limits.distance * widening < limits.max_warp) {
      limits.distance *= widening;
      freeCurved();
      growLarge(seeds, limits);
    }
    is_wide_ = false;
  }

  std::vector<GrownPlane>
  take()
  {
    return std::move(grown_);
  }

private:
  template <typename Accept>
  void
  grow(const std::vector<std::int32_t>& seeds,
       const PlaneLimits& limits,
       const Accept& accept)
  {
    growPlanes(graph_, neighbours_, limits, seeds, next_, owner_, accept);
  }

  bool
  keep(const Members& members, const PlaneRegion& region, double area, PlaneTrust trust)
  {
    const double warp =
        is_wide_ ? std::sqrt(fitPlane(region.moments()).variances[0]) : 0;
    grown_.push_back({members, region.moments(), region.plane(), area, trust, warp});
    return true;
  }

  bool
  isBent(const Members& members, const PlaneRegion& region, const PlaneLimits& limits)
  {
    if (!isCurved(graph_, members, owner_, region, limits.cosine))
      return false;
    ++report_.curved_regions;
    report_.points_on_curved += members.size();
    for (const std::int32_t member : members)
      owner_[static_cast<std::size_t>(member)] = curved_surface;
    return true;
  }

  void
  freeCurved()
  {
    std::replace(owner_.begin(), owner_.end(), curved_surface, no_region);
    report_.curved_regions = report_.points_on_curved = 0;
  }

  const CellGraph& graph_;
  MeshNeighbourhood neighbours_;
  double min_area_;
  PlaneClusteringReport& report_;
  std::vector<std::int32_t> owner_;
  std::vector<GrownPlane> grown_;
  std::int32_t next_ = 0; ///< number of the next region
  bool is_wide_ = false;  ///< is the band wider than for noise alone?
};

} // namespace

std::vector<GrownPlane>
growNoiseDriven(const CellGraph& graph,
                const std::vector<std::int32_t>& seeds,
                const PlaneLimits& limits,
                double min_area,
                PlaneClusteringReport& report)
{
  NoiseDrivenGrowth growth(graph, min_area, report);
  growth.growLarge(seeds, limits);
  if (limits.bow > 0)
    growth.growWarped(seeds, limits);
  growth.growRest(seeds, limits);
  return growth.take();
}

} // namespace pcl::acmap::planes
