#include "planes/plane_merge.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::acmap::planes {
namespace {

/** Mean squared distance of points with the given moments from a plane. */
double
meanSquare(const Moments& m, const Plane& plane)
{
  const Eigen::Vector3d& n = plane.normal;
  const double square =
      n.x() * n.x() * m.xx + n.y() * n.y() * m.yy + n.z() * n.z() * m.zz +
      2 * (n.x() * n.y() * m.xy + n.x() * n.z() * m.xz + n.y() * n.z() * m.yz);
  const double linear = n.x() * m.x + n.y() * m.y + n.z() * m.z;
  const double sum =
      square + 2 * plane.offset * linear + m.count * plane.offset * plane.offset;
  return std::max(sum / m.count, 0.0);
}

Plane
throughMiddle(const Moments& moments, const Eigen::Vector3d& normal)
{
  return {normal, -normal.dot(moments.mean())};
}

} // namespace

double
excess(const GrownPlane& grown, const Plane& plane)
{
  const double more =
      meanSquare(grown.moments, plane) - meanSquare(grown.moments, grown.plane);
  return std::sqrt(std::max(more, 0.0));
}

std::vector<std::int32_t>
ownersOf(const CellGraph& graph, const std::vector<GrownPlane>& planes)
{
  std::vector<std::int32_t> owner(graph.size(), no_region);
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (const std::int32_t member : planes[p].members)
      owner[static_cast<std::size_t>(member)] = static_cast<std::int32_t>(p);
  return owner;
}

namespace {

/** The normal of the largest plane that is parallel within the tolerances: a small
 * patch does not determine its plane ten metres away, but a parallel wall provides the
 * direction. */
Eigen::Vector3d
surestNormal(const std::vector<GrownPlane>& planes,
             const GrownPlane& patch,
             double cosine,
             double distance)
{
  const Eigen::Vector3d& own = patch.plane.normal;
  for (const GrownPlane& other : planes) {
    if (other.area <= patch.area)
      break;
    const double along = other.plane.normal.dot(own);
    if (other.members.empty() || std::abs(along) < cosine)
      continue;
    const Eigen::Vector3d normal =
        along < 0 ? Eigen::Vector3d(-other.plane.normal) : other.plane.normal;
    if (excess(patch, throughMiddle(patch.moments, normal)) < distance)
      return normal;
  }
  return own;
}

/** Computes the common plane, if there is one. With a free normal, any two small
 * patches far apart would have one. */
bool
fitsTogether(const GrownPlane& a,
             const GrownPlane& b,
             const Eigen::Vector3d& normal,
             double cosine,
             double distance,
             Plane& common)
{
  if (a.plane.normal.dot(b.plane.normal) < cosine)
    return false;
  const Plane plane_a = throughMiddle(a.moments, normal);
  const Plane plane_b = throughMiddle(b.moments, normal);
  if (std::abs(plane_a.offset - plane_b.offset) > distance ||
      excess(b, plane_b) > distance)
    return false;
  Moments both = a.moments;
  both += b.moments;
  const PlaneFit fit = fitPlane(both);
  common = planeThrough(fit, a.plane.normal);
  return excess(a, common) < distance && excess(b, common) < distance;
}

} // namespace

void
takeIn(GrownPlane& into, GrownPlane& other, const Plane& common)
{
  into.members.insert(into.members.end(), other.members.begin(), other.members.end());
  into.moments += other.moments;
  into.area += other.area;
  into.warp = std::max(into.warp, other.warp);
  into.plane = common;
  other.members.clear();
}

void
dropEmpty(std::vector<GrownPlane>& planes)
{
  planes.erase(std::remove_if(planes.begin(),
                              planes.end(),
                              [](const GrownPlane& p) { return p.members.empty(); }),
               planes.end());
}

std::size_t
mergePlanes(std::vector<GrownPlane>& planes, double cosine, double distance)
{
  std::stable_sort(planes.begin(), planes.end(), [](const auto& a, const auto& b) {
    return a.trust != b.trust ? a.trust < b.trust : a.area > b.area;
  });
  std::size_t merged = 0;
  // A larger plane may absorb what it could not absorb before, so repeat until nothing
  // changes.
  for (std::size_t before = merged + 1; before != merged;) {
    before = merged;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (planes[i].members.empty())
        continue;
      const Eigen::Vector3d normal = surestNormal(planes, planes[i], cosine, distance);
      for (std::size_t j = i + 1; j < planes.size(); ++j) {
        Plane common;
        if (planes[j].members.empty() ||
            !fitsTogether(planes[i], planes[j], normal, cosine, distance, common))
          continue;
        takeIn(planes[i], planes[j], common);
        ++merged;
      }
    }
  }
  dropEmpty(planes);
  return merged;
}

} // namespace pcl::acmap::planes
