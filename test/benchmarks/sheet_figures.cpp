#include "sheet_figures.h"

#include "statistics.h"

#include <cmath>

namespace pcl::acmap::bench {
namespace {

using Raster = std::vector<std::uint8_t>;

bool
isClear(const SceneTruth& truth,
        const TruthSurface& surface,
        const Eigen::Vector3d& point,
        double voxel)
{
  return truth.distanceToOthers(point, surface, false) > creaseMargin(voxel);
}

/** Marks the cells within a radius along the surface. */
void
markDisc(const TruthSurface& surface,
         const Eigen::Vector3d& place,
         double radius,
         Raster& raster)
{
  const Eigen::Vector2d cell =
      surface.size.array() / surface.cells.cast<double>().array();
  const auto first = [&](int axis) {
    return std::max(0,
                    static_cast<int>(std::floor((place[axis] - radius) / cell[axis])));
  };
  const auto last = [&](int axis) {
    return std::min(surface.cells[axis] - 1,
                    static_cast<int>(std::floor((place[axis] + radius) / cell[axis])));
  };
  for (int i = first(0); i <= last(0); ++i)
    for (int j = first(1); j <= last(1); ++j)
      if (std::hypot((i + 0.5) * cell[0] - place[0], (j + 0.5) * cell[1] - place[1]) <=
          radius)
        raster[surface.cellIndex(i, j)] = 1;
}

/** Counts the visible and the marked cells of a surface. */
void
countCells(const SceneTruth& truth,
           const TruthSurface& surface,
           const Raster& raster,
           double voxel,
           std::size_t& visible,
           std::size_t& covered)
{
  for (int i = 0; i < surface.cells[0]; ++i)
    for (int j = 0; j < surface.cells[1]; ++j) {
      const std::size_t cell = surface.cellIndex(i, j);
      if (!surface.visible[cell] ||
          !isClear(truth, surface, surface.cellCenter(i, j), voxel))
        continue;
      ++visible;
      covered += raster[cell];
    }
}

} // namespace

SheetFigures
measureSheet(const SceneTruth& truth,
             std::int32_t plane,
             const test::Points& places,
             const test::Points& normals,
             double voxel)
{
  constexpr double near = 0.03;
  const std::vector<TruthSurface>& surfaces = truth.surfaces();
  std::vector<Raster> rasters;
  for (const TruthSurface& surface : surfaces)
    rasters.emplace_back(surface.plane == plane ? surface.visible.size() : 0, 0);

  SheetFigures sheet;
  std::size_t turned = 0;
  std::vector<double> depth_errors;
  for (std::size_t r = 0; r < places.size(); ++r) {
    const TruthSurface& surface = truth.nearest(places[r]);
    if (surface.plane != plane)
      continue;
    const Eigen::Vector3d place = surface.coordinates(places[r]);
    const bool is_turned = !(normals[r].dot(surface.normal) > 0);
    if (!is_turned && std::abs(place[2]) <= near)
      markDisc(surface,
               place,
               voxel,
               rasters[static_cast<std::size_t>(&surface - surfaces.data())]);
    if (!isClear(truth, surface, places[r], voxel))
      continue;
    ++sheet.representatives;
    sheet.depth_error += std::abs(place[2]);
    depth_errors.push_back(std::abs(place[2]));
    sheet.shift += place[2];
    turned += is_turned;
  }
  std::size_t visible = 0, covered = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    if (surfaces[s].plane == plane)
      countCells(truth, surfaces[s], rasters[s], voxel, visible, covered);
  sheet.cover = percent(covered, visible);
  sheet.depth_error /= static_cast<double>(sheet.representatives);
  constexpr double nearly_all = 0.95;
  sheet.p95_depth_error = quantile(depth_errors, nearly_all);
  sheet.shift /= static_cast<double>(sheet.representatives);
  sheet.turned = percent(turned, sheet.representatives);
  return sheet;
}

} // namespace pcl::acmap::bench
