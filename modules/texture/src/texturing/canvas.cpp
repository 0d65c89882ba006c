#include "texturing/canvas.h"

#include <pcl/core/exceptions.h>

namespace pcl::acmap::texturing {
namespace {

using Grids = std::vector<std::optional<ChartGrid>>;

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

double
texelsOf(const Grids& grids)
{
  double texels = 0;
  for (const std::optional<ChartGrid>& grid : grids)
    texels += grid ? grid->columns * grid->rows : 0;
  return texels;
}

} // namespace

double
canvasBytes(const std::vector<PlanePatch>& planes, double texel_size)
{
  constexpr std::size_t finished = 4; // bytes of colour and kind
  return texelsOf(gridsOf(planes, texel_size)) *
         (sizeof(TexelPlace) + sizeof(Canvas::Samples) + finished);
}

std::vector<Canvas>
canvasesOf(const std::vector<PlanePatch>& planes,
           double texel_size,
           int most,
           std::size_t& left_out)
{
  const Grids grids = gridsOf(planes, texel_size);
  constexpr double max_texels = 1 << 28;
  if (texelsOf(grids) > max_texels)
    throw BadArgumentException("the charts have more than 2^28 texels: choose larger "
                               "ones");
  std::vector<Canvas> canvases;
  auto grid = grids.begin();
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (std::size_t k = 0; k < planes[p].polygons.size(); ++k, ++grid) {
      left_out += *grid ? 0 : 1;
      if (*grid)
        for (TextureChart& chart : chartsOf(**grid, p, k, most))
          canvases.emplace_back().chart = std::move(chart);
    }
  for (Canvas& canvas : canvases) {
    canvas.mask =
        maskOf(canvas.chart, planes[canvas.chart.plane].polygons[canvas.chart.polygon]);
    canvas.samples.resize(canvas.mask.size());
  }
  return canvases;
}

} // namespace pcl::acmap::texturing
