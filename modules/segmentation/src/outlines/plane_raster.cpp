#include "outlines/plane_raster.h"

#include "outlines/sight_rays.h"

#include <pcl/core/impl/parallel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::acmap::outlines {

namespace {

using Box = Eigen::AlignedBox3d;

/** Boxes around the points of each plane. */
std::vector<Box>
boxesOf(const KnownPlanes& known)
{
  std::vector<Box> boxes(known.planes.size());
  for (std::size_t i = 0; i < known.labels.size(); ++i)
    if (known.labels[i] >= 0)
      boxes[static_cast<std::size_t>(known.labels[i])].extend(
          known.points[i].cast<double>());
  return boxes;
}

/** The direction in a plane along which most of its neighbours cross it, weighted by
 * their areas; directions at right angles count as one. */
Eigen::Vector3d
mainDirection(std::size_t own,
              const std::vector<KnownPlane>& planes,
              const std::vector<Box>& boxes,
              double reach)
{
  constexpr double min_sine = 0.17;
  const PlanePatch& patch = planes[own].patch;
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  Box around = boxes[own];
  around.min().array() -= reach;
  around.max().array() += reach;
  std::array<double, 90> weights{}; // by degree
  std::array<Eigen::Vector2d, 90> sums;
  sums.fill(Eigen::Vector2d::Zero());
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Eigen::Vector3d along = normal.cross(planes[p].patch.coefficients.head<3>());
    if (p == own || along.norm() < min_sine || !around.intersects(boxes[p]))
      continue;
    const double angle = std::atan2(along.dot(patch.axis_v), along.dot(patch.axis_u));
    const double turns = angle / (M_PI / 2);
    const double share = turns - std::floor(turns);
    const auto degree = std::min<std::size_t>(static_cast<std::size_t>(90 * share), 89);
    const double weight = std::max(planes[p].patch.area, 1e-6) * along.norm();
    weights[degree] += weight;
    sums[degree] += weight * Eigen::Vector2d(std::cos(4 * angle), std::sin(4 * angle));
  }
  std::size_t best = 0;
  double best_weight = 0;
  const auto smoothed = [&](std::size_t k) {
    return weights[(k + 89) % 90] + weights[k] + weights[(k + 1) % 90];
  };
  for (std::size_t k = 0; k < 90; ++k)
    if (smoothed(k) > best_weight) {
      best = k;
      best_weight = smoothed(k);
    }
  if (best_weight == 0)
    return patch.axis_u;
  const Eigen::Vector2d sum =
      sums[(best + 89) % 90] + sums[best] + sums[(best + 1) % 90];
  const double angle = std::atan2(sum.y(), sum.x()) / 4;
  return std::cos(angle) * patch.axis_u + std::sin(angle) * patch.axis_v;
}

/** Adds the cells whose centres are in a triangle. Each side bounds the rows from the
 * left or from the right, which is chosen without a branch. */
void
fillTriangle(const std::array<Eigen::Vector2d, 3>& corners, CellSet& cells)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double turn = cross(Eigen::Vector2d(corners[1] - corners[0]),
                            Eigen::Vector2d(corners[2] - corners[0]));
  if (turn == 0)
    return;
  const double low = std::min({corners[0].y(), corners[1].y(), corners[2].y()});
  const double high = std::max({corners[0].y(), corners[1].y(), corners[2].y()});
  const int first = std::max(static_cast<int>(low + 0.5) - 1, 0);
  const int last = std::min(static_cast<int>(high + 0.5) - 1, cells.height() - 1);
  std::array<double, 3> left, left_slopes, right, right_slopes;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d &a = corners[k], &b = corners[(k + 1) % 3];
    const double rise = b.y() - a.y();
    const double slope = rise == 0 ? 0 : (b.x() - a.x()) / rise;
    const double x = a.x() + (first + 0.5 - a.y()) * slope;
    const bool is_left = rise * turn<0, is_right = rise * turn> 0;
    left[k] = is_left ? x : -infinity;
    left_slopes[k] = is_left ? slope : 0;
    right[k] = is_right ? x : infinity;
    right_slopes[k] = is_right ? slope : 0;
  }
  for (int y = first; y <= last; ++y) {
    const double from = std::max({left[0], left[1], left[2], 0.0});
    const double to =
        std::min({right[0], right[1], right[2], static_cast<double>(cells.width())});
    if (from <= to && y + 0.5 >= low)
      cells.addRun(y, static_cast<int>(from + 0.5), static_cast<int>(to + 0.5));
    for (std::size_t k = 0; k < 3; ++k) {
      left[k] += left_slopes[k];
      right[k] += right_slopes[k];
    }
  }
}

} // namespace

void
fillLoops(const std::vector<Loop>& loops, CellSet& cells)
{
  std::vector<double> crossings;
  for (int y = 0; y < cells.height(); ++y) {
    crossings.clear();
    for (const Loop& loop : loops)
      for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Eigen::Vector2d &a = loop[i], &b = loop[j];
        if ((a.y() > y + 0.5) != (b.y() > y + 0.5))
          crossings.push_back(a.x() +
                              (b.x() - a.x()) * (y + 0.5 - a.y()) / (b.y() - a.y()));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      cells.addRun(y,
                   static_cast<int>(std::ceil(crossings[k] - 0.5)),
                   static_cast<int>(std::ceil(crossings[k + 1] - 0.5)));
  }
}

std::vector<PlaneRaster>
rastersOf(const KnownPlanes& known)
{
  constexpr double margin = 16; // cells; more than any search goes beyond the surface
  constexpr double max_cells = 1 << 28;
  const std::vector<Box> boxes = boxesOf(known);
  std::vector<PlaneRaster> rasters(known.planes.size());
  for (std::size_t p = 0; p < rasters.size(); ++p) {
    PlaneRaster& raster = rasters[p];
    const PlanePatch& patch = known.planes[p].patch;
    raster.normal = patch.coefficients.head<3>();
    raster.offset = patch.coefficients[3];
    raster.cell = known.spacing / 2;
    raster.box = boxes[p];
    raster.axis_u = mainDirection(p, known.planes, boxes, 4 * known.spacing);
    raster.axis_u =
        (raster.axis_u - raster.axis_u.dot(raster.normal) * raster.normal).normalized();
    raster.axis_v = raster.normal.cross(raster.axis_u);
    raster.origin = patch.center;
  }
  std::vector<Eigen::AlignedBox2d> extents(rasters.size());
  for (std::size_t i = 0; i < known.labels.size(); ++i)
    if (known.labels[i] >= 0) {
      const auto p = static_cast<std::size_t>(known.labels[i]);
      extents[p].extend(rasters[p].placeOf(known.points[i].cast<double>()));
    }
  for (std::size_t p = 0; p < rasters.size(); ++p) {
    if (extents[p].isEmpty())
      continue;
    const Eigen::Vector2d size = extents[p].sizes().array() + 2 * margin + 1;
    const Eigen::Vector2d corner = extents[p].min().array() - margin;
    if (!(size.x() * size.y() <= max_cells))
      continue;
    rasters[p].origin = rasters[p].pointAt(corner);
    rasters[p].seen = CellSet(static_cast<int>(size.x()), static_cast<int>(size.y()));
    rasters[p].free = rasters[p].barrier = rasters[p].seen;
  }
  return rasters;
}

namespace {

/** A point and its plane side by side: faces look points up in any order. */
struct LabeledPlace {
  double x = 0, y = 0; ///< in the raster of the plane
  std::int32_t plane = -1;
};

std::vector<LabeledPlace>
placesOf(const KnownPlanes& known, const std::vector<PlaneRaster>& rasters)
{
  std::vector<LabeledPlace> places(known.labels.size());
  parallelForChunks(places.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int32_t plane = known.labels[i];
      if (plane < 0)
        continue;
      const Eigen::Vector2d place = rasters[static_cast<std::size_t>(plane)].placeOf(
          known.points[i].cast<double>());
      places[i] = {place.x(), place.y(), plane};
    }
  });
  return places;
}

} // namespace

void
addFaces(const TriangleMesh::Triangles& triangles,
         const KnownPlanes& known,
         std::vector<PlaneRaster>& rasters)
{
  const double max_off = known.spacing / 2;
  const std::vector<LabeledPlace> places = placesOf(known, rasters);
  constexpr std::size_t ahead =
      12; // faces; the order of their points is no order in memory
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const TriangleMesh::Triangle& t = triangles[i];
    for (const std::int32_t corner :
         triangles[std::min(i + ahead, triangles.size() - 1)])
      __builtin_prefetch(&places[static_cast<std::size_t>(corner)]);
    const std::array<const LabeledPlace*, 3> ends{
        &places[static_cast<std::size_t>(t[0])],
        &places[static_cast<std::size_t>(t[1])],
        &places[static_cast<std::size_t>(t[2])]};
    std::int32_t plane = -1, strangers = 0;
    bool is_one = true;
    for (const LabeledPlace* const end : ends) {
      strangers += end->plane < 0 ? 1 : 0;
      is_one &= end->plane < 0 || plane < 0 || end->plane == plane;
      plane = std::max(plane, end->plane);
    }
    if (!is_one || strangers > 1)
      continue;
    PlaneRaster& raster = rasters[static_cast<std::size_t>(plane)];
    std::array<Eigen::Vector2d, 3> corners;
    bool is_near = true;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {ends[k]->x, ends[k]->y};
      if (ends[k]->plane >= 0)
        continue;
      const Eigen::Vector3d point =
          known.points[static_cast<std::size_t>(t[k])].cast<double>();
      is_near = std::abs(raster.normal.dot(point) + raster.offset) <= max_off;
      corners[k] = raster.placeOf(point);
    }
    if (!is_near)
      continue;
    fillTriangle(corners, raster.seen);
    for (std::size_t k = 0; k < 3; ++k)
      if (ends[k]->plane < 0)
        raster.rim_points.push_back(corners[k]);
  }
  for (const LabeledPlace& place : places)
    if (place.plane >= 0) {
      PlaneRaster& raster = rasters[static_cast<std::size_t>(place.plane)];
      if (!raster.seen.hasAround({place.x, place.y}, 3))
        raster.rim_points.emplace_back(place.x, place.y);
    }
}

void
addFreeRays(const KnownPlanes& known,
            const SightRays& rays,
            std::vector<PlaneRaster>& rasters)
{
  if (!rays.areKnown())
    return;
  constexpr double spacings = 2, deviations = 4; // behind a plane, beyond its noise
  oneapi::tbb::parallel_for(std::size_t{0}, rasters.size(), [&](std::size_t p) {
    PlaneRaster& raster = rasters[p];
    if (raster.seen.width() == 0)
      return;
    const Eigen::Array2d size(raster.free.width(), raster.free.height());
    rays.forEachThrough(
        raster,
        {Eigen::Vector2d::Zero(), size.matrix()},
        std::max(spacings * known.spacing, deviations * known.planes[p].patch.rms),
        [&](const Eigen::Array2d& place) {
          if ((place >= 0).all() && (place < size).all())
            raster.free.add(static_cast<int>(place.x()), static_cast<int>(place.y()));
        });
  });
}

} // namespace pcl::acmap::outlines
