#include "map_faces.h"

#include <pcl/core/cylinder_facets.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/chart_clip.h>
#include <pcl/core/polygon_triangles.h>

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace pcl::acmap {

namespace {

using Eigen::Vector3d;
using Polygon = std::pair<std::size_t, std::size_t>; // numbers of plane and polygon

/** Has a picture as many colours as texels, and as many kinds or none? */
bool
isWhole(const TexturePicture& picture)
{
  const RgbImage& image = picture.colors;
  const auto texels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  return image.values.size() == 3 * texels &&
         (picture.kinds.empty() || picture.kinds.size() == texels);
}

void
requireSound(const CompactMap& map, const TextureChart& chart)
{
  const auto refuse = [](const std::string& fault) {
    throw acmap::BadArgument("a chart of the map " + fault);
  };
  if (chart.plane >= map.planes.size())
    refuse("is of plane " + std::to_string(chart.plane) + ", which is not there");
  if (chart.polygon >= map.planes[chart.plane].polygons.size())
    refuse("is of polygon " + std::to_string(chart.polygon) + " of plane " +
           std::to_string(chart.plane) + ", which is not there");
  const std::string fault = faultOfFrame(chart);
  if (!fault.empty())
    refuse(fault);
  if (!isWhole(chart))
    refuse("has not as many colours or kinds as texels");
}

/** \brief The charts of each polygon that have colours. */
std::map<Polygon, std::vector<const TextureChart*>>
chartsByPolygon(const CompactMap& map)
{
  std::map<Polygon, std::vector<const TextureChart*>> charts;
  for (const TextureChart& chart : map.charts) {
    if (chart.colors.values.empty())
      continue;
    requireSound(map, chart);
    charts[{chart.plane, chart.polygon}].push_back(&chart);
  }
  return charts;
}

/** Faces of a cylinder: a rectangle for each facet, with places in the unrolled picture. */
MapFaces
facesOf(const CylinderPatch& cylinder, std::size_t number)
{
  MapFaces faces;
  faces.plane = number;
  const std::vector<PlanePatch> facets = facetsOfCylinder(cylinder);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    std::vector<std::int32_t>& face = faces.faces.emplace_back();
    for (const Eigen::Vector3f& corner : facets[i].polygons.front().outer) {
      face.push_back(static_cast<std::int32_t>(faces.points.size()));
      faces.points.push_back(corner);
    }
    for (const Eigen::Vector2d& place : unrolledCorners(cylinder, i, facets.size()))
      faces.places.emplace_back(place.cast<float>());
  }
  return faces;
}

MapFaces
cutAt(const TextureChart& chart, const MapFaces& whole)
{
  MapFaces faces;
  faces.plane = whole.plane;
  faces.polygon = whole.polygon;
  faces.chart = &chart;
  const ChartClip clip(chart);
  const Eigen::Array2d size(chart.colors.width, chart.colors.height);
  for (const auto& triangle : whole.faces) {
    std::array<Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = whole.points[static_cast<std::size_t>(triangle[i])].cast<double>();
    const std::vector<ChartCorner> part = clip.clipped(corners);
    if (part.size() < 3)
      continue;
    std::vector<std::int32_t>& face = faces.faces.emplace_back();
    for (const ChartCorner& corner : part) {
      face.push_back(static_cast<std::int32_t>(faces.points.size()));
      faces.points.push_back(corner.point.cast<float>());
      faces.places.emplace_back((corner.place.array() / size).cast<float>());
    }
  }
  return faces;
}

/** The picture of a cylinder; null if it has no colours.
 * \throws BadArgumentException for a picture that does not fit */
const TexturePicture*
pictureOf(const CompactMap& map, std::size_t cylinder)
{
  if (cylinder >= map.cylinder_pictures.size() ||
      map.cylinder_pictures[cylinder].colors.values.empty())
    return nullptr;
  const TexturePicture& picture = map.cylinder_pictures[cylinder];
  if (!isWhole(picture))
    throw acmap::BadArgument("the picture of a cylinder of the map has not as many "
                             "colours or kinds as texels");
  return &picture;
}

double
areaOf(const MapFaces& faces)
{
  double area = 0;
  for (const auto& face : faces.faces)
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Eigen::Vector3f& a = faces.points[face[0]];
      area += (faces.points[face[i - 1]] - a)
                  .cross(faces.points[face[i]] - a)
                  .cast<double>()
                  .norm() /
              2;
    }
  return area;
}

/** \brief Adds a lattice of points inside a triangle. */
void
addLattice(const Eigen::Vector3f& a,
           const Eigen::Vector3f& b,
           const Eigen::Vector3f& c,
           double spacing,
           std::vector<Eigen::Vector3f>& samples)
{
  const double area = (b - a).cross(c - a).cast<double>().norm() / 2;
  const int rows = std::max(1, static_cast<int>(std::sqrt(area) / spacing));
  const auto step = 1.0F / static_cast<float>(rows);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; i + j < rows; ++j)
      samples.push_back(a + (static_cast<float>(i) + 1.0F / 3) * step * (b - a) +
                        (static_cast<float>(j) + 1.0F / 3) * step * (c - a));
}

/** \brief Intersection of a ray with a triangle, as a multiple of the direction
 * (Moeller and Trumbore, 1997); nothing if there is none. */
std::optional<double>
distanceTo(const Vector3d& eye,
           const Vector3d& direction,
           const Vector3d& a,
           const Vector3d& b,
           const Vector3d& c,
           bool fronts_only)
{
  const Vector3d p = direction.cross(c - a);
  const double volume = p.dot(b - a); // positive if the front faces the eye
  if (volume == 0 || (fronts_only && volume < 0))
    return {};
  const Vector3d way = eye - a;
  const double u = way.dot(p) / volume;
  const Vector3d q = way.cross(b - a);
  const double v = direction.dot(q) / volume;
  const double distance = (c - a).dot(q) / volume;
  if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0)
    return distance;
  return {};
}

} // namespace

std::vector<MapFaces>
facesOf(const CompactMap& map)
{
  std::vector<MapFaces> all;
  for (std::size_t plane = 0; plane < map.planes.size(); ++plane) {
    const PlanePatch& patch = map.planes[plane];
    const Vector3d normal = patch.coefficients.head<3>();
    if (!normal.allFinite() || normal.norm() == 0)
      continue;
    for (std::size_t polygon = 0; polygon < patch.polygons.size(); ++polygon) {
      const auto triangles = trianglesOfPolygon(patch.polygons[polygon], normal);
      if (triangles.empty())
        continue;
      MapFaces& faces = all.emplace_back();
      faces.plane = plane;
      faces.polygon = polygon;
      faces.points = pointsOfPolygon(patch.polygons[polygon]);
      for (const TriangleMesh::Triangle& triangle : triangles)
        faces.faces.emplace_back(triangle.begin(), triangle.end());
    }
  }
  for (std::size_t i = 0; i < map.cylinders.size(); ++i) {
    MapFaces faces = facesOf(map.cylinders[i], map.planes.size() + i);
    if (!faces.faces.empty())
      all.push_back(std::move(faces));
  }
  return all;
}

std::vector<MapFaces>
cutFaces(const CompactMap& map, const std::vector<MapFaces>& faces)
{
  const auto charts = chartsByPolygon(map);
  std::vector<MapFaces> cut;
  for (const MapFaces& whole : faces) {
    if (whole.plane >= map.planes.size()) {
      cut.push_back(whole);
      cut.back().chart = pictureOf(map, whole.plane - map.planes.size());
      continue;
    }
    const auto found = charts.find({whole.plane, whole.polygon});
    if (found == charts.end())
      cut.push_back(whole);
    else
      for (const TextureChart* const chart : found->second)
        cut.push_back(cutAt(*chart, whole));
  }
  return cut;
}

std::vector<Eigen::Vector3f>
samplesOf(const std::vector<MapFaces>& faces)
{
  constexpr double wanted = 20000;
  double area = 0;
  for (const MapFaces& part : faces)
    area += areaOf(part);
  if (!(area > 0) || !std::isfinite(area))
    throw acmap::InitFailed("nothing to show: no plane of the map has an area");
  // a lattice of n rows has n^2 / 2 points
  const double spacing = std::sqrt(area / wanted / 2);
  std::vector<Eigen::Vector3f> samples;
  for (const MapFaces& part : faces)
    for (const auto& face : part.faces) {
      for (const std::int32_t corner : face)
        samples.push_back(part.points[corner]);
      for (std::size_t i = 2; i < face.size(); ++i)
        addLattice(part.points[face[0]],
                   part.points[face[i - 1]],
                   part.points[face[i]],
                   spacing,
                   samples);
    }
  return samples;
}

std::optional<RayHit>
firstHit(const std::vector<MapFaces>& faces,
         const Vector3d& eye,
         const Vector3d& direction,
         bool fronts_only)
{
  std::optional<RayHit> first;
  for (const MapFaces& part : faces) {
    const auto corner = [&](std::int32_t i) -> Vector3d {
      return part.points[static_cast<std::size_t>(i)].cast<double>();
    };
    for (const auto& face : part.faces)
      for (std::size_t i = 2; i < face.size(); ++i) {
        const auto distance = distanceTo(eye,
                                         direction,
                                         corner(face[0]),
                                         corner(face[i - 1]),
                                         corner(face[i]),
                                         fronts_only);
        if (distance && (!first || *distance < first->distance))
          first = {part.plane, *distance};
      }
  }
  return first;
}

} // namespace pcl::acmap
