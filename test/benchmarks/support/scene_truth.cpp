#include "scene_truth.h"

#include "bench.h"

#include <pcl/simulation/ray_casting.h>

#include <Eigen/Geometry>

namespace pcl::acmap::bench {

namespace {

TruthSurface
makeTruthSurface(const SimulatedRectangle& rectangle, std::int32_t plane, double cell)
{
  TruthSurface surface;
  surface.rectangle = rectangle;
  surface.plane = plane;
  surface.unit_u = rectangle.edge_u.normalized();
  surface.unit_v = rectangle.edge_v.normalized();
  surface.normal = rectangle.normal();
  surface.size = {rectangle.edge_u.norm(), rectangle.edge_v.norm()};
  // multiples of the cell must not get an extra cell because of rounding
  surface.cells = (surface.size.array() / cell - 1e-6).ceil().max(1.0).cast<int>();
  surface.visible.assign(static_cast<std::size_t>(surface.cells.prod()), 0);
  return surface;
}

TrinocularRig
finerRig(TrinocularRig rig, int factor)
{
  rig.width *= factor;
  rig.height *= factor;
  rig.focal_length *= factor;
  rig.center_x = (rig.center_x + 0.5) * factor - 0.5;
  rig.center_y = (rig.center_y + 0.5) * factor - 0.5;
  return rig;
}

int
cellOf(double coordinate, double size, int cells)
{
  return std::clamp(static_cast<int>(coordinate / size * cells), 0, cells - 1);
}

void
markCell(TruthSurface& surface, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d place = surface.coordinates(point);
  const int i = cellOf(place[0], surface.size[0], surface.cells[0]);
  const int j = cellOf(place[1], surface.size[1], surface.cells[1]);
  surface.visible[surface.cellIndex(i, j)] = 1;
}

} // namespace

Eigen::Vector3d
TruthSurface::coordinates(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d offset = point - rectangle.corner;
  return {offset.dot(unit_u), offset.dot(unit_v), offset.dot(normal)};
}

double
TruthSurface::distance(const Eigen::Vector3d& point) const
{
  const Eigen::Vector3d place = coordinates(point);
  const double beyond_u = std::max({-place[0], place[0] - size[0], 0.0});
  const double beyond_v = std::max({-place[1], place[1] - size[1], 0.0});
  return Eigen::Vector3d(beyond_u, beyond_v, place[2]).norm();
}

double
TruthSurface::cellArea() const
{
  return size.prod() / static_cast<double>(cells.prod());
}

Eigen::Vector3d
TruthSurface::cellCenter(int i, int j) const
{
  return rectangle.corner + (i + 0.5) / cells[0] * rectangle.edge_u +
         (j + 0.5) / cells[1] * rectangle.edge_v;
}

SceneTruth::SceneTruth(const SimulatedScene& scene, double cell)
{
  for (const SimulatedSurface& surface : scene.geometry.surfaces()) {
    const auto* rectangle = std::get_if<SimulatedRectangle>(&surface.shape);
    of_scene_.push_back(rectangle ? static_cast<std::int32_t>(surfaces_.size()) : -1);
    if (rectangle)
      surfaces_.push_back(makeTruthSurface(*rectangle, surface.plane, cell));
  }
}

void
SceneTruth::see(const SimulatedScene& scene, std::size_t view, int factor)
{
  const TrinocularRig rig = finerRig(scene.rig, factor);
  const Eigen::Isometry3d& T_scene_camera = scene.views[view];
  const SurfaceImage image =
      castView(scene.geometry, rig, T_scene_camera, scene.sensor.reach);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
          static_cast<std::size_t>(column);
      const std::int32_t seen = image.surface[pixel];
      const std::int32_t place =
          seen < 0 ? -1 : of_scene_[static_cast<std::size_t>(seen)];
      if (place >= 0)
        markCell(surfaces_[static_cast<std::size_t>(place)],
                 T_scene_camera * (image.distance[pixel] * pixelRay(rig, column, row)));
    }
}

double
SceneTruth::visibleArea() const
{
  double area = 0;
  for (const TruthSurface& surface : surfaces_)
    area += surface.cellArea() *
            static_cast<double>(
                std::count(surface.visible.begin(), surface.visible.end(), 1));
  return area;
}

const TruthSurface&
SceneTruth::nearest(const Eigen::Vector3d& point) const
{
  std::size_t best = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const double distance = surfaces_[i].distance(point);
    if (distance < minimum) {
      minimum = distance;
      best = i;
    }
  }
  return surfaces_[best];
}

double
SceneTruth::distanceToOthers(const Eigen::Vector3d& point,
                             const TruthSurface& own,
                             bool parallel) const
{
  constexpr double parallel_cosine = 0.9;
  double minimum = std::numeric_limits<double>::infinity();
  for (const TruthSurface& other : surfaces_)
    if (other.plane != own.plane &&
        (parallel || std::abs(other.normal.dot(own.normal)) < parallel_cosine))
      minimum = std::min(minimum, other.distance(point));
  return minimum;
}

double
creaseMargin(double voxel)
{
  constexpr double sigma = 0.025;
  return voxel + 2 * sigma;
}

namespace {

using test::Points;
using test::Triangle;
using test::Triangles;

using Corners = std::array<Eigen::Vector3d, 3>;

/** Number of triangles above each cell of the truth. */
class CoverRaster {
public:
  CoverRaster(const SceneTruth& truth, double tolerance)
  : truth_(truth)
  , tolerance_(tolerance)
  {
    for (const TruthSurface& surface : truth.surfaces())
      counts_.emplace_back(surface.visible.size(), 0);
  }

  void
  add(const Corners& corners)
  {
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    double reach = tolerance_;
    for (const Eigen::Vector3d& corner : corners)
      reach = std::max(reach, tolerance_ + (corner - middle).norm());
    for (std::size_t s = 0; s < counts_.size(); ++s)
      if (truth_.surfaces()[s].distance(middle) <= reach)
        addTo(s, corners);
  }

  void
  count(MeshFigures& figures) const
  {
    std::size_t visible = 0, covered = 0, overlapped = 0;
    for (std::size_t s = 0; s < counts_.size(); ++s)
      for (std::size_t cell = 0; cell < counts_[s].size(); ++cell)
        if (truth_.surfaces()[s].visible[cell]) {
          ++visible;
          covered += counts_[s][cell] > 0;
          overlapped += counts_[s][cell] > 1;
        }
    figures.cover = percent(covered, visible);
    figures.overlap = percent(overlapped, visible);
  }

private:
  /** x and y in cells, with integers at the cells' centres; z in metres. */
  static Corners
  inCells(const TruthSurface& surface, const Corners& corners)
  {
    Corners result;
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = surface.coordinates(corners[k]);
      for (int axis = 0; axis < 2; ++axis)
        result[k][axis] =
            result[k][axis] * surface.cells[axis] / surface.size[axis] - 0.5;
    }
    return result;
  }

  void
  addTo(std::size_t s, const Corners& corners)
  {
    const TruthSurface& surface = truth_.surfaces()[s];
    const Corners place = inCells(surface, corners);
    const Eigen::Vector3d along_b = place[1] - place[0];
    const Eigen::Vector3d along_c = place[2] - place[0];
    const double area = along_b.x() * along_c.y() - along_c.x() * along_b.y();
    constexpr double min_area = 1e-12; // seen edge-on
    if (std::abs(area) < min_area)
      return;
    Eigen::Array3d minimum =
        place[0].array().min(place[1].array()).min(place[2].array());
    Eigen::Array3d maximum =
        place[0].array().max(place[1].array()).max(place[2].array());
    const int first_i = std::max(0, static_cast<int>(std::ceil(minimum[0])));
    const int first_j = std::max(0, static_cast<int>(std::ceil(minimum[1])));
    const int last_i =
        std::min(surface.cells[0] - 1, static_cast<int>(std::floor(maximum[0])));
    const int last_j =
        std::min(surface.cells[1] - 1, static_cast<int>(std::floor(maximum[1])));
    for (int i = first_i; i <= last_i; ++i)
      for (int j = first_j; j <= last_j; ++j) {
        const double x = i - place[0].x();
        const double y = j - place[0].y();
        const double b = (x * along_c.y() - along_c.x() * y) / area;
        const double c = (along_b.x() * y - x * along_b.y()) / area;
        constexpr double rounding = 1e-9;
        if (b < -rounding || c < -rounding || b + c > 1 + rounding)
          continue;
        const double height = place[0].z() + b * along_b.z() + c * along_c.z();
        std::uint8_t& count = counts_[s][surface.cellIndex(i, j)];
        if (std::abs(height) <= tolerance_ && count < 2)
          ++count;
      }
  }

  const SceneTruth& truth_;
  double tolerance_;
  std::vector<std::vector<std::uint8_t>> counts_; // saturated at 2
};

double
angleDegrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / M_PI;
}

} // namespace

NormalErrors
measureNormals(const SceneTruth& truth,
               const Points& places,
               const Points& normals,
               double voxel)
{
  std::vector<double> all, away;
  std::size_t backs_all = 0, backs_away = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!normals[i].allFinite())
      continue;
    const TruthSurface& surface = truth.nearest(places[i]);
    const double error = angleDegrees(normals[i], surface.normal);
    all.push_back(error);
    const bool is_back = error > 90;
    backs_all += is_back;
    if (truth.distanceToOthers(places[i], surface) <= creaseMargin(voxel))
      continue;
    away.push_back(error);
    backs_away += is_back;
  }
  constexpr double nearly_all = 0.95;
  return {median(away),
          quantile(away, nearly_all),
          median(all),
          quantile(all, nearly_all),
          percent(backs_away, away.size()),
          percent(backs_all, all.size())};
}

void
addErrors(const NormalErrors& errors, Row& row, double median_reach, double p95_reach)
{
  row << atMost(errors.median_away, median_reach, 2)
      << atMost(errors.p95_away, p95_reach, 1) << figure(errors.backs_away, 2)
      << figure(errors.median_all, 2) << figure(errors.p95_all, 1)
      << figure(errors.backs_all, 2);
}

MeshFigures
measureMesh(const SceneTruth& truth,
            const Points& points,
            const Triangles& triangles,
            double voxel)
{
  constexpr double min_tolerance = 0.05;
  CoverRaster raster(truth, std::max(min_tolerance, voxel / 2));
  Points middles, normals;
  double area = 0;
  for (const Triangle& t : triangles) {
    const Corners corners = {points[t[0]], points[t[1]], points[t[2]]};
    const Eigen::Vector3d cross =
        (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    area += cross.norm() / 2;
    normals.push_back(cross.normalized());
    middles.push_back((corners[0] + corners[1] + corners[2]) / 3);
    raster.add(corners);
  }
  MeshFigures figures;
  figures.normals = measureNormals(truth, middles, normals, voxel);
  raster.count(figures);
  figures.area = 100 * (area / truth.visibleArea() - 1);
  const test::MeshCounts counts = test::countMesh(points, triangles);
  figures.boundary = percent(counts.boundary_edges, counts.edges);
  return figures;
}

} // namespace pcl::acmap::bench
