#include "texturing/canvas.h"

#include "texturing/chart_frame.h"

#include <pcl/core/cylinder_facets.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/impl/size_text.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::texturing {

namespace {

using Grids = std::vector<std::optional<ChartGrid>>;

constexpr double most_texels = 1 << 28; ///< of a map

/** Grids of all polygons, plane by plane. */
Grids
gridsOf(const std::vector<PlanePatch>& planes, double texel_size)
{
  Grids grids;
  for (const PlanePatch& plane : planes)
    for (std::size_t k = 0; k < plane.polygons.size(); ++k)
      grids.push_back(gridOf(plane, k, texel_size));
  return grids;
}

/** Size of an unrolled cylinder in texels, integral, possibly too large for an int; 0 if
 * it cannot be drawn. */
Eigen::Array2d
unrolledSize(const CylinderPatch& cylinder, double texel_size)
{
  if (facetsOfCylinder(cylinder).empty())
    return {0, 0};
  return (Eigen::Array2d(cylinder.arc * cylinder.radius, cylinder.high - cylinder.low) /
          texel_size)
      .ceil();
}

double
texelsOf(const Grids& grids,
         const std::vector<CylinderPatch>& cylinders,
         double texel_size)
{
  double texels = 0;
  for (const std::optional<ChartGrid>& grid : grids)
    texels += grid ? grid->columns * grid->rows : 0;
  for (const CylinderPatch& cylinder : cylinders)
    texels += unrolledSize(cylinder, texel_size).prod();
  return texels;
}

/** The canvas of a cylinder, all of whose texels belong to it. */
Canvas
canvasOf(const CylinderPatch& cylinder, const Eigen::Array2d& size, int maximum)
{
  TextureChart chart;
  chart.colors.width = static_cast<std::int32_t>(std::min<double>(size.x(), maximum));
  chart.colors.height = static_cast<std::int32_t>(std::min<double>(size.y(), maximum));
  const CanvasSurface surface(cylinder, chart.colors);
  Canvas canvas{0, std::move(chart), surface, {}, {}, {}, {}};
  canvas.mask.assign(static_cast<std::size_t>(canvas.chart.colors.width) *
                         static_cast<std::size_t>(canvas.chart.colors.height),
                     TexelPlace::Inside);
  return canvas;
}

/** Positions at which the centre line of each row crosses the loops. */
using Crossings = std::vector<std::vector<double>>;

void
addLoop(const TextureChart& chart,
        const std::vector<Eigen::Vector3f>& loop,
        Crossings& crossings)
{
  for (std::size_t k = 0; k < loop.size(); ++k) {
    Eigen::Vector2d a = placeOn(chart, loop[k].cast<double>());
    Eigen::Vector2d b = placeOn(chart, loop[(k + 1) % loop.size()].cast<double>());
    if (a.y() > b.y())
      std::swap(a, b);
    // rows whose centre is in [a, b), so that a corner is counted once
    const double rows = static_cast<double>(crossings.size());
    const double first = std::clamp(std::ceil(a.y() - 0.5), 0.0, rows);
    const double end = std::clamp(std::ceil(b.y() - 0.5), 0.0, rows);
    for (double row = first; row < end; ++row) {
      const double share = (row + 0.5 - a.y()) / (b.y() - a.y());
      crossings[static_cast<std::size_t>(row)].push_back(a.x() +
                                                         share * (b.x() - a.x()));
    }
  }
}

void
addRim(std::size_t width, std::size_t height, LargeVector<TexelPlace>& mask)
{
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      if (mask[row * width + column] != TexelPlace::Inside)
        continue;
      const std::size_t top = row > 0 ? row - 1 : 0;
      const std::size_t left = column > 0 ? column - 1 : 0;
      for (std::size_t r = top; r <= std::min(row + 1, height - 1); ++r)
        for (std::size_t c = left; c <= std::min(column + 1, width - 1); ++c)
          if (mask[r * width + c] == TexelPlace::Outside)
            mask[r * width + c] = TexelPlace::Rim;
    }
}

} // namespace

double
boundedTexelSize(const std::vector<PlanePatch>& planes,
                 const std::vector<CylinderPatch>& cylinders,
                 double texel_size,
                 double max_texels,
                 double max_enlargement)
{
  for (double size = texel_size; size <= max_enlargement * texel_size;) {
    const double texels = texelsOf(gridsOf(planes, size), cylinders, size);
    if (texels <= max_texels)
      return size;
    // the rest is for rows and columns that are cut
    size *= 1.001 * std::sqrt(texels / max_texels);
  }
  return texel_size;
}

double
canvasTexels(const std::vector<PlanePatch>& planes,
             const std::vector<CylinderPatch>& cylinders,
             double texel_size)
{
  return texelsOf(gridsOf(planes, texel_size), cylinders, texel_size);
}

std::vector<Canvas>
canvasesOf(const std::vector<PlanePatch>& planes,
           const std::vector<CylinderPatch>& cylinders,
           double texel_size,
           int maximum,
           std::size_t& left_out)
{
  const Grids grids = gridsOf(planes, texel_size);
  if (texelsOf(grids, cylinders, texel_size) > most_texels)
    throw acmap::BadArgument("the charts have more than 2^28 texels of ",
                             shortNumber(texel_size),
                             " m: choose larger ones, if the lengths are metres");
  std::vector<Canvas> canvases;
  auto grid = grids.begin();
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (std::size_t k = 0; k < planes[p].polygons.size(); ++k, ++grid) {
      left_out += *grid ? 0 : 1;
      if (*grid)
        for (TextureChart& chart : chartsOf(**grid, p, k, maximum)) {
          const CanvasSurface surface(chart, planes[p]);
          canvases.push_back({p, std::move(chart), surface, {}, {}, {}, {}});
        }
    }
  for (Canvas& canvas : canvases)
    canvas.mask =
        maskOf(canvas.chart, planes[canvas.number].polygons[canvas.chart.polygon]);
  for (std::size_t i = 0; i < cylinders.size(); ++i) {
    const Eigen::Array2d size = unrolledSize(cylinders[i], texel_size);
    if (size.minCoeff() > 0) {
      canvases.push_back(canvasOf(cylinders[i], size, maximum));
      canvases.back().number = planes.size() + i;
    }
    else
      ++left_out;
  }
  return canvases;
}

LargeVector<TexelPlace>
maskOf(const TextureChart& chart, const PlanePolygon& polygon)
{
  const auto width = static_cast<std::size_t>(chart.colors.width);
  const auto height = static_cast<std::size_t>(chart.colors.height);
  Crossings crossings(height);
  addLoop(chart, polygon.outer, crossings);
  for (const std::vector<Eigen::Vector3f>& hole : polygon.holes)
    addLoop(chart, hole, crossings);
  LargeVector<TexelPlace> mask(width * height, TexelPlace::Outside);
  for (std::size_t row = 0; row < height; ++row) {
    std::vector<double>& cuts = crossings[row];
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
      const double columns = static_cast<double>(width);
      const double first = std::clamp(std::ceil(cuts[k] - 0.5), 0.0, columns);
      const double end = std::clamp(std::ceil(cuts[k + 1] - 0.5), 0.0, columns);
      for (double column = first; column < end; ++column)
        mask[row * width + static_cast<std::size_t>(column)] = TexelPlace::Inside;
    }
  }
  addRim(width, height, mask);
  return mask;
}

} // namespace pcl::acmap::texturing
