#include "outlines/surface_cells.h"

#include <cmath>

namespace pcl::acmap::outlines {

namespace {

// Lengths in cells, of which two are a spacing.
constexpr double max_fill = 10, cut = 6, kept = 7;
constexpr double closing = 3, opening = 1.6;
constexpr std::int64_t min_part = 36;
constexpr std::int64_t max_hole = 144, max_hole_without_sensors = 36;
constexpr double sliver = 0.01; // m^2

struct CellPlace {
  int x, y;
};

/** Calls visit (line, span, place) for places half a cell apart along all spans of a
 * plane. */
template <typename Visit>
void
visitSpans(std::size_t plane, const Creases& creases, const Visit& visit)
{
  for (const std::size_t number : creases.of_planes[plane]) {
    const Crease& crease = creases.creases[number];
    const std::size_t k = crease.sideOf(plane);
    const double step = 0.5 / crease.lines[k].cells_per_metre;
    for (const CreaseSpan& span : crease.spans[k])
      for (double along = span.from + step / 2; along < span.to; along += step)
        visit(crease.lines[k], span, crease.lines[k].at(along));
  }
}

CellPlace
cellAt(const Eigen::Vector2d& place)
{
  return {static_cast<int>(std::floor(place.x())),
          static_cast<int>(std::floor(place.y()))};
}

/** Removes what is beyond the creases. */
void
cutBeyond(std::size_t plane,
          const Creases& creases,
          PlaneRaster& raster,
          CellSet& cells)
{
  visitSpans(plane,
             creases,
             [&](const CreaseLine& line, const CreaseSpan& span, const auto& place) {
               for (double distance = 0.25; distance < cut; distance += 0.5) {
                 const CellPlace at =
                     cellAt(place - span.side * distance * line.normal);
                 const Eigen::Vector2d center(at.x + 0.5, at.y + 0.5);
                 if (span.side * line.distance(center) > 0)
                   continue;
                 cells.remove(at.x, at.y);
                 raster.barrier.add(at.x, at.y);
               }
             });
}

/** Fills from the creases to the first cells that were seen, and restores what another
 * crease has cut off beside them. */
void
fillUpTo(std::size_t plane,
         const Creases& creases,
         PlaneRaster& raster,
         CellSet& cells,
         CellSet& filled)
{
  visitSpans(plane,
             creases,
             [&](const CreaseLine& line, const CreaseSpan& span, const auto& place) {
               double first = 0.25;
               const auto at = [&](double distance) {
                 return cellAt(place + span.side * distance * line.normal);
               };
               while (first < max_fill && !raster.seen.has(at(first).x, at(first).y))
                 first += 0.5;
               if (first >= max_fill)
                 return;
               for (double distance = 0.25; distance < std::max(first, kept);
                    distance += 0.5) {
                 const CellPlace cell = at(distance);
                 const Eigen::Vector2d center(cell.x + 0.5, cell.y + 0.5);
                 if ((distance >= first && !raster.seen.has(cell.x, cell.y)) ||
                     span.side * line.distance(center) < 0)
                   continue;
                 cells.add(cell.x, cell.y);
                 filled.add(cell.x, cell.y);
                 raster.barrier.remove(cell.x, cell.y);
               }
             });
}

std::int64_t
countOf(const std::vector<CellRun>& part, const CellSet& cells)
{
  std::int64_t count = 0;
  for (const CellRun& run : part)
    for (int x = run.from; x < run.to; ++x)
      count += cells.has(x, run.y) ? 1 : 0;
  return count;
}

void
dropSpecks(CellSet& cells)
{
  CellSet kept_cells(cells.width(), cells.height());
  for (const std::vector<CellRun>& part : partsOf(cells, false))
    if (sizeOf(part) >= min_part)
      for (const CellRun& run : part)
        kept_cells.addRun(run.y, run.from, run.to);
  cells = std::move(kept_cells);
}

/** Fills small holes that no sensor looked through and that end at no crease. */
void
fillHoles(const PlaneRaster& raster, bool knows_sensors, CellSet& cells)
{
  constexpr double max_free = 0.3, max_barrier = 0.15;
  const std::vector<std::vector<CellRun>> parts = partsOf(cells.complement(), true);
  for (std::size_t i = 1; i < parts.size(); ++i) { // the first one is the outside
    const std::int64_t size = sizeOf(parts[i]);
    const bool is_sliver =
        static_cast<double>(size) * raster.cell * raster.cell < sliver;
    if (!is_sliver && size > (knows_sensors ? max_hole : max_hole_without_sensors))
      continue;
    const auto share = [&](const CellSet& set) {
      return static_cast<double>(countOf(parts[i], set)) / static_cast<double>(size);
    };
    if (share(raster.free) < max_free && share(raster.barrier) < max_barrier)
      for (const CellRun& run : parts[i])
        cells.addRun(run.y, run.from, run.to);
  }
}

} // namespace

CellSet
surfaceCells(std::size_t plane,
             const Creases& creases,
             bool knows_sensors,
             PlaneRaster& raster)
{
  CellSet cells = raster.seen;
  CellSet filled(cells.width(), cells.height());
  cutBeyond(plane, creases, raster, cells);
  fillUpTo(plane, creases, raster, cells, filled);
  CellSet closed = cells.dilated(closing).eroded(closing);
  closed -= raster.barrier;
  closed -= raster.free;
  cells |= closed;
  filled &= cells;
  cells = cells.eroded(opening).dilated(opening);
  cells |= filled;
  dropSpecks(cells);
  fillHoles(raster, knows_sensors, cells);
  return cells;
}

} // namespace pcl::acmap::outlines
