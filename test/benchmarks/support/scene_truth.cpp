#include "scene_truth.h"

#include <pcl/simulation/ray_casting.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

} // namespace pcl::acmap::bench
