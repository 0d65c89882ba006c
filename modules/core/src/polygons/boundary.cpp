#include "polygons/boundary.h"

#include <Eigen/Geometry>

namespace pcl::acmap {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double
areaOf(const std::vector<Eigen::Vector3f>& points, const Vector3d& normal)
{
  Vector3d sum = Vector3d::Zero();
  const Vector3d origin = points[0].cast<double>();
  for (std::size_t i = 2; i < points.size(); ++i)
    sum += (points[i - 1].cast<double>() - origin)
               .cross(points[i].cast<double>() - origin);
  return sum.dot(normal) / 2;
}

/** Do two segments cross, apart from common ends? */
bool
doCross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
  const auto side = [](const auto& from, const auto& to, const auto& at) {
    const Vector2d way = to - from, there = at - from;
    return way.x() * there.y() - way.y() * there.x();
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

} // namespace

std::vector<Boundary>
boundariesOf(const PlanePolygon& polygon)
{
  std::vector<Boundary> boundaries{{polygon.outer, {}}};
  for (const auto& hole : polygon.holes)
    boundaries.push_back({hole, {}});
  auto next = polygon.edges.begin();
  for (Boundary& boundary : boundaries) {
    boundary.edges.resize(boundary.points.size());
    for (PolygonEdge& edge : boundary.edges)
      if (next != polygon.edges.end())
        edge = *next++;
  }
  return boundaries;
}

PlanePolygon
polygonOf(const std::vector<Boundary>& boundaries)
{
  PlanePolygon polygon;
  polygon.outer = boundaries[0].points;
  for (std::size_t i = 1; i < boundaries.size(); ++i)
    polygon.holes.push_back(boundaries[i].points);
  for (const Boundary& boundary : boundaries)
    polygon.edges.insert(
        polygon.edges.end(), boundary.edges.begin(), boundary.edges.end());
  return polygon;
}

double
areaOf(const std::vector<Boundary>& boundaries, const Vector3d& normal)
{
  double area = 0;
  for (const Boundary& boundary : boundaries)
    area += boundary.points.size() < 3 ? 0 : areaOf(boundary.points, normal);
  return area;
}

bool
mayReplace(const std::vector<Boundary>& before,
           const std::vector<Boundary>& after,
           const PlanePatch& plane)
{
  const Vector3d normal = plane.coefficients.head<3>();
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  struct Segment {
    Vector2d from, to;
    bool is_arc;
  };
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const std::vector<Eigen::Vector3f>& points = after[i].points;
    const std::vector<PolygonEdge>& edges = after[i].edges;
    if (points.size() < 3 ||
        areaOf(points, normal) * areaOf(before[i].points, normal) <= 0)
      return false;
    const auto flat = [&](std::size_t k) {
      const Vector3d point = points[k % points.size()].cast<double>() - plane.center;
      return Vector2d(point.dot(u), point.dot(v));
    };
    for (std::size_t k = 0; k < points.size(); ++k)
      segments.push_back({flat(k), flat(k + 1), edges[k].kind == EdgeKind::Arc});
  }
  for (std::size_t a = 0; a < segments.size(); ++a)
    if (segments[a].is_arc)
      for (const Segment& other : segments)
        if (doCross(segments[a].from, segments[a].to, other.from, other.to))
          return false;
  return true;
}

} // namespace pcl::acmap
