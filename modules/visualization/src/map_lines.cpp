#include "map_lines.h"

#include <pcl/core/cylinder_facets.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

namespace pcl::acmap {
namespace {

using Eigen::Vector3d;

std::vector<Eigen::Vector3f>
finitePoints(const std::vector<Eigen::Vector3f>& loop)
{
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3f& point : loop)
    if (point.allFinite())
      points.push_back(point);
  return points;
}

std::vector<std::vector<Eigen::Vector3f>>
loopsOf(const PlanePolygon& polygon)
{
  std::vector<std::vector<Eigen::Vector3f>> loops = {finitePoints(polygon.outer)};
  for (const auto& hole : polygon.holes)
    loops.push_back(finitePoints(hole));
  return loops;
}

} // namespace

void
append(std::vector<MapLine>& lines, std::vector<MapLine> more)
{
  std::move(more.begin(), more.end(), std::back_inserter(lines));
}

std::vector<MapLine>
outlinesOf(const CompactMap& map, std::size_t plane)
{
  std::vector<MapLine> lines;
  for (const PlanePolygon& polygon : map.planes[plane].polygons)
    for (auto& loop : loopsOf(polygon)) {
      if (loop.size() < 2)
        continue;
      loop.push_back(loop.front());
      lines.push_back({plane, std::move(loop)});
    }
  return lines;
}

std::vector<MapLine>
rimOf(const CompactMap& map, std::size_t cylinder)
{
  const std::vector<PlanePatch> facets = facetsOfCylinder(map.cylinders[cylinder]);
  if (facets.empty())
    return {};
  // Corners 0 and 3 of a facet are where it begins, 1 and 2 where the next one does.
  MapLine rim{map.planes.size() + cylinder, {facets[0].polygons[0].outer[0]}};
  for (const PlanePatch& facet : facets)
    rim.points.push_back(facet.polygons[0].outer[1]);
  for (auto facet = facets.rbegin(); facet != facets.rend(); ++facet)
    rim.points.push_back(facet->polygons[0].outer[2]);
  rim.points.push_back(facets[0].polygons[0].outer[3]);
  rim.points.push_back(rim.points.front());
  return {rim};
}

std::vector<MapLine>
sectionOf(const PlanePatch& plane, std::size_t number, const Vector3d& up, double level)
{
  const Vector3d normal = plane.coefficients.head<3>();
  const Vector3d along = up.cross(normal);
  std::vector<MapLine> lines;
  for (const PlanePolygon& polygon : plane.polygons) {
    std::vector<Vector3d> crossings;
    for (const auto& loop : loopsOf(polygon))
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vector3d a = loop[i].cast<double>();
        const Vector3d b = loop[(i + 1) % loop.size()].cast<double>();
        const double da = a.dot(up) - level, db = b.dot(up) - level;
        if ((da > 0) != (db > 0))
          crossings.push_back(a + da / (da - db) * (b - a));
      }
    // along the line, crossings alternate between entering and leaving the polygons
    std::sort(crossings.begin(), crossings.end(), [&](const auto& a, const auto& b) {
      return a.dot(along) < b.dot(along);
    });
    for (std::size_t i = 1; i < crossings.size(); i += 2)
      lines.push_back(
          {number, {crossings[i - 1].cast<float>(), crossings[i].cast<float>()}});
  }
  return lines;
}

} // namespace pcl::acmap
