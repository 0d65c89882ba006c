#include "export/chart_surface.h"

#include <pcl/core/box_sides.h>
#include <pcl/core/cylinder_facets.h>
#include <pcl/core/impl/chart_clip.h>
#include <pcl/core/impl/map_pictures.h>
#include <pcl/core/polygon_triangles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::acmap {

namespace {

/** \brief Collects triangles and merges equal corners. */
class SurfaceBuilder {
public:
  explicit SurfaceBuilder(ChartSurface& surface)
  : surface_(surface)
  {}

  void
  append(const ChartCorner& a, const ChartCorner& b, const ChartCorner& c)
  {
    const Eigen::Vector3d turn = (b.point - a.point).cross(c.point - a.point);
    if (turn.squaredNorm() > 0)
      surface_.triangles.push_back({indexOf(a), indexOf(b), indexOf(c)});
  }

private:
  std::int32_t
  indexOf(const ChartCorner& corner)
  {
    const Eigen::Vector3d& p = corner.point;
    const Eigen::Vector2d& at = corner.place;
    const auto next = static_cast<std::int32_t>(surface_.points.size());
    const auto [place, is_new] =
        indices_.try_emplace({p.x(), p.y(), p.z(), at.x(), at.y()}, next);
    if (is_new) {
      surface_.points.push_back(p);
      surface_.places.push_back(corner.place);
    }
    return place->second;
  }

  ChartSurface& surface_;
  std::map<std::array<double, 5>, std::int32_t> indices_; ///< by point and place
};

/** Triangulates a polygon; returns three points per triangle. */
std::vector<std::array<Eigen::Vector3d, 3>>
trianglesOf(const PlanePatch& plane, const PlanePolygon& polygon)
{
  const std::vector<Eigen::Vector3f> points = pointsOfPolygon(polygon);
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  for (const auto& triangle : trianglesOfPolygon(polygon, plane.coefficients.head<3>()))
    triangles.push_back({points[static_cast<std::size_t>(triangle[0])].cast<double>(),
                         points[static_cast<std::size_t>(triangle[1])].cast<double>(),
                         points[static_cast<std::size_t>(triangle[2])].cast<double>()});
  return triangles;
}

using Triangles = std::vector<std::array<Eigen::Vector3d, 3>>;

ChartSurface
surfaceOfChart(const TextureChart& chart,
               const PlanePatch& plane,
               const Triangles& triangles)
{
  ChartSurface surface;
  surface.plane = chart.plane;
  surface.normal = plane.coefficients.head<3>();
  SurfaceBuilder builder(surface);
  const ChartClip clip(chart);
  for (const auto& triangle : triangles) {
    const std::vector<ChartCorner> piece = clip.clipped(triangle);
    for (std::size_t i = 2; i < piece.size(); ++i)
      builder.append(piece[0], piece[i - 1], piece[i]);
  }
  return surface;
}

ChartSurface
surfaceOfPolygon(std::size_t number,
                 const PlanePatch& plane,
                 const Triangles& triangles)
{
  ChartSurface surface;
  surface.plane = number;
  surface.normal = plane.coefficients.head<3>();
  SurfaceBuilder builder(surface);
  for (const auto& [a, b, c] : triangles)
    builder.append({a, {0, 0}}, {b, {0, 0}}, {c, {0, 0}});
  return surface;
}

/** The facets of a cylinder with its picture. Corners at the seam of a closed cylinder have
 * two places, and are therefore doubled. */
ChartSurface
surfaceOfCylinder(const CylinderPatch& cylinder,
                  const std::vector<PlanePatch>& facets,
                  const TexturePicture& picture)
{
  ChartSurface surface;
  surface.normal = cylinder.axis_u;
  SurfaceBuilder builder(surface);
  const Eigen::Array2d size(picture.colors.width, picture.colors.height);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto shares = unrolledCorners(cylinder, i, facets.size());
    const auto corner = [&](std::size_t k) {
      return ChartCorner{facets[i].polygons[0].outer[k].cast<double>(),
                         shares[k].array() * size};
    };
    builder.append(corner(0), corner(1), corner(2));
    builder.append(corner(0), corner(2), corner(3));
  }
  return surface;
}

void
appendCylinder(const CompactMap& map,
               std::size_t number,
               std::vector<ChartSurface>& surfaces)
{
  const CylinderPatch& cylinder = map.cylinders[number];
  const std::vector<PlanePatch> facets = facetsOfCylinder(cylinder);
  const std::size_t surface = map.planes.size() + number;
  if (facets.empty() || map.cylinder_pictures.empty() ||
      !hasColor(map.cylinder_pictures[number])) {
    for (const PlanePatch& facet : facets)
      surfaces.push_back(
          surfaceOfPolygon(surface, facet, trianglesOf(facet, facet.polygons.front())));
    return;
  }
  surfaces.push_back(
      surfaceOfCylinder(cylinder, facets, map.cylinder_pictures[number]));
  surfaces.back().plane = surface;
  surfaces.back().chart = map.charts.size() + number;
}

} // namespace

std::vector<ChartSurface>
surfacesOf(const CompactMap& map)
{
  std::map<std::pair<std::size_t, std::size_t>, Triangles> cut;
  std::vector<ChartSurface> surfaces;
  for (std::size_t i = 0; i < map.charts.size(); ++i) {
    const TextureChart& chart = map.charts[i];
    const PlanePatch& plane = map.planes[chart.plane];
    const auto [place, is_new] =
        cut.try_emplace({chart.plane, chart.polygon}, Triangles());
    if (is_new)
      place->second = trianglesOf(plane, plane.polygons[chart.polygon]);
    surfaces.push_back(surfaceOfChart(chart, plane, place->second));
    surfaces.back().chart = i;
  }
  for (std::size_t i = 0; i < map.planes.size(); ++i)
    for (std::size_t k = 0; k < map.planes[i].polygons.size(); ++k)
      if (cut.count({i, k}) == 0)
        surfaces.push_back(surfaceOfPolygon(
            i, map.planes[i], trianglesOf(map.planes[i], map.planes[i].polygons[k])));
  for (std::size_t i = 0; i < map.cylinders.size(); ++i)
    appendCylinder(map, i, surfaces);
  return surfaces;
}

std::vector<ChartSurface>
proposedSurfacesOf(const CompactMap& map)
{
  std::vector<ChartSurface> surfaces;
  for (std::size_t i = 0; i < map.planes.size(); ++i)
    for (const PlanePolygon& polygon : map.planes[i].proposed)
      surfaces.push_back(
          surfaceOfPolygon(i, map.planes[i], trianglesOf(map.planes[i], polygon)));
  for (std::size_t i = 0; i < map.boxes.size(); ++i)
    for (const PlanePatch& side : freeSidesOf(map.boxes[i]))
      surfaces.push_back(surfaceOfPolygon(map.planes.size() + map.cylinders.size() + i,
                                          side,
                                          trianglesOf(side, side.polygons.front())));
  return surfaces;
}

std::vector<bool>
coverOf(const ChartSurface& surface, const RgbImage& image)
{
  constexpr double slack = 1e-9; // avoids gaps along the edges of triangles
  std::vector<bool> cover(image.values.size() / 3);
  for (const TriangleMesh::Triangle& triangle : surface.triangles) {
    const auto corner = [&](std::size_t i) {
      return surface.places[static_cast<std::size_t>(triangle[i % 3])];
    };
    const auto [minimum, maximum] =
        std::minmax({corner(0).y(), corner(1).y(), corner(2).y()});
    const auto last = std::min<std::int32_t>(
        image.height - 1, static_cast<std::int32_t>(std::floor(maximum - 0.5 + slack)));
    for (auto row = static_cast<std::int32_t>(std::ceil(minimum - 0.5 - slack));
         row <= last;
         ++row) {
      const double y = std::clamp(row + 0.5, minimum, maximum);
      double from = std::numeric_limits<double>::infinity();
      double to = -from;
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d a = corner(i);
        const Eigen::Vector2d b = corner(i + 1);
        if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y)
          continue;
        const double share = a.y() == b.y() ? 0.0 : (y - a.y()) / (b.y() - a.y());
        const double x = a.x() + share * (b.x() - a.x());
        from = std::min({from, x, a.y() == b.y() ? b.x() : x});
        to = std::max({to, x, a.y() == b.y() ? b.x() : x});
      }
      const auto first = static_cast<std::int32_t>(std::ceil(from - 0.5 - slack));
      const auto end = static_cast<std::int32_t>(std::floor(to - 0.5 + slack));
      for (std::int32_t i = std::max(first, 0); i <= std::min(end, image.width - 1);
           ++i)
        cover[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(i)] = true;
    }
  }
  return cover;
}

} // namespace pcl::acmap
