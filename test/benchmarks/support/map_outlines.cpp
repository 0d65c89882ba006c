#include "map_outlines.h"

#include "statistics.h"

#include <pcl/core/impl/polyline_corners.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

namespace pcl::acmap::bench {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using PointBits = std::array<std::uint32_t, 3>;
using EdgeBits = std::array<PointBits, 2>;

PointBits
bitsOf(const Eigen::Vector3f& point)
{
  PointBits bits;
  std::memcpy(bits.data(), point.data(), sizeof bits);
  return bits;
}

EdgeBits
bitsOf(const Eigen::Vector3f& a, const Eigen::Vector3f& b)
{
  EdgeBits bits{bitsOf(a), bitsOf(b)};
  std::sort(bits.begin(), bits.end());
  return bits;
}

/** \brief All loops of a polygon, the outer one first. */
std::vector<std::vector<Eigen::Vector3f>>
loopsOf(const PlanePolygon& polygon)
{
  std::vector<std::vector<Eigen::Vector3f>> loops{polygon.outer};
  loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
  return loops;
}

template <typename Visitor>
void
forEachEdge(const PlanePatch& plane, const Visitor& visit)
{
  for (const PlanePolygon& polygon : plane.polygons)
    for (const std::vector<Eigen::Vector3f>& loop : loopsOf(polygon))
      for (std::size_t k = 0; k < loop.size(); ++k)
        visit(loop[k], loop[(k + 1) % loop.size()]);
}

double
signedArea(const FlatLoop& loop)
{
  double twice = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Eigen::Vector2d& a = loop[k];
    const Eigen::Vector2d& b = loop[(k + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/** \brief Signed distance of a point from the line through a segment. */
double
sideOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point)
{
  const Eigen::Vector2d along = (b - a).normalized();
  const Eigen::Vector2d off = point - a;
  return along.x() * off.y() - along.y() * off.x();
}

/** \brief Do segments cross in their interiors? Those that touch do not. */
bool
cross(const Eigen::Vector2d& a,
      const Eigen::Vector2d& b,
      const Eigen::Vector2d& c,
      const Eigen::Vector2d& d)
{
  constexpr double touch = 1e-5; // metres, more than coordinates are rounded by
  const auto areOpposite = [](double s, double t) {
    return (s > touch && t < -touch) || (s < -touch && t > touch);
  };
  return areOpposite(sideOf(a, b, c), sideOf(a, b, d)) &&
         areOpposite(sideOf(c, d, a), sideOf(c, d, b));
}

bool
crossesItself(const std::vector<FlatLoop>& polygon)
{
  std::vector<std::array<Eigen::Vector2d, 2>> edges;
  for (const FlatLoop& loop : polygon)
    for (std::size_t k = 0; k < loop.size(); ++k)
      edges.push_back({loop[k], loop[(k + 1) % loop.size()]});
  for (std::size_t a = 0; a < edges.size(); ++a)
    for (std::size_t b = a + 1; b < edges.size(); ++b)
      if (cross(edges[a][0], edges[a][1], edges[b][0], edges[b][1]))
        return true;
  return false;
}

} // namespace

double
OutlineEdge::distance(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d along = to - from;
  const double length = along.squaredNorm();
  const double part =
      length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - from - part * along).norm();
}

bool
PlaneOutline::contains(const Eigen::Vector3d& point) const
{
  const Eigen::Vector2d place = frame.flat(point);
  for (const std::vector<FlatLoop>& polygon : polygons) {
    bool is_inside = false;
    for (const FlatLoop& loop : polygon)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Eigen::Vector2d& a = loop[k];
        const Eigen::Vector2d& b = loop[(k + 1) % loop.size()];
        if ((a.x() > place.x()) != (b.x() > place.x()) &&
            a.y() + (place.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) > place.y())
          is_inside = !is_inside;
      }
    if (is_inside)
      return true;
  }
  return false;
}

double
PlaneOutline::distanceWithin(const Eigen::Vector3d& point) const
{
  if (contains(point))
    return 0;
  const Eigen::Vector2d place = frame.flat(point);
  double minimum = infinite;
  for (const std::vector<FlatLoop>& polygon : polygons)
    for (const FlatLoop& loop : polygon)
      for (std::size_t k = 0; k < loop.size(); ++k)
        minimum = std::min(
            minimum,
            std::sqrt(squaredDistance(place, loop[k], loop[(k + 1) % loop.size()])));
  return minimum;
}

double
PlaneOutline::distanceToEdges(const Eigen::Vector3d& point) const
{
  double minimum = infinite;
  for (const OutlineEdge& edge : edges)
    minimum = std::min(minimum, edge.distance(point));
  return minimum;
}

double
PlaneOutline::distanceToSurface(const Eigen::Vector3d& point) const
{
  if (contains(point))
    return std::abs(coefficients.head<3>().dot(point) + coefficients[3]);
  return distanceToEdges(point);
}

std::vector<PlaneOutline>
makeOutlines(const std::vector<PlanePatch>& planes, const Eigen::Isometry3d& T_out_map)
{
  std::map<EdgeBits, std::vector<std::size_t>> users;
  for (std::size_t p = 0; p < planes.size(); ++p)
    forEachEdge(planes[p], [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      std::vector<std::size_t>& of_edge = users[bitsOf(a, b)];
      if (of_edge.empty() || of_edge.back() != p)
        of_edge.push_back(p);
    });
  std::vector<PlaneOutline> outlines(planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    PlaneOutline& outline = outlines[p];
    const Eigen::Vector3d normal =
        T_out_map.linear() * planes[p].coefficients.head<3>();
    outline.coefficients << normal,
        planes[p].coefficients[3] - normal.dot(T_out_map.translation());
    outline.frame = makePlaneFrame(outline.coefficients);
    forEachEdge(planes[p], [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      OutlineEdge& edge = outline.edges.emplace_back();
      edge.from = T_out_map * a.cast<double>();
      edge.to = T_out_map * b.cast<double>();
      outline.box.extend(edge.from);
      for (const std::size_t user : users[bitsOf(a, b)])
        if (user != p)
          edge.partners.push_back(user);
    });
    std::size_t next = 0;
    for (const PlanePolygon& polygon : planes[p].polygons) {
      std::vector<FlatLoop>& loops = outline.polygons.emplace_back();
      for (const std::vector<Eigen::Vector3f>& loop : loopsOf(polygon)) {
        outline.first_edges.push_back(next);
        next += loop.size();
        FlatLoop& flat = loops.emplace_back();
        for (const Eigen::Vector3f& place : loop)
          flat.push_back(outline.frame.flat(T_out_map * place.cast<double>()));
      }
    }
  }
  return outlines;
}

OutlineCounts
countOutlines(const std::vector<PlaneOutline>& outlines)
{
  constexpr double sliver = 0.01; // square metres
  OutlineCounts counts;
  counts.planes = outlines.size();
  std::vector<double> vertices;
  for (const PlaneOutline& outline : outlines) {
    vertices.push_back(static_cast<double>(outline.edges.size()));
    counts.vertices_mean += vertices.back() / static_cast<double>(outlines.size());
    for (const std::vector<FlatLoop>& polygon : outline.polygons) {
      ++counts.polygons;
      counts.holes += polygon.size() - 1;
      counts.crossed += crossesItself(polygon);
      counts.area += std::abs(signedArea(polygon.front()));
      for (std::size_t hole = 1; hole < polygon.size(); ++hole) {
        const double area = std::abs(signedArea(polygon[hole]));
        counts.area -= area;
        counts.slivers += area < sliver;
      }
    }
  }
  counts.vertices_median = median(vertices);
  return counts;
}

} // namespace pcl::acmap::bench
