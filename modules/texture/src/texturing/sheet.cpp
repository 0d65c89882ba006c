#include "texturing/sheet.h"

#include <cmath>

namespace pcl::acmap::texturing {

namespace {

/** Does a canvas continue the row of another one? */
bool
isBeside(const Canvas& a, const Canvas& b)
{
  const Eigen::Vector3d& down = a.chart.texel_v;
  return std::abs((b.chart.origin - a.chart.origin).dot(down)) <
         0.5 * down.squaredNorm();
}

/** Are they parts of one polygon? */
bool
belongTogether(const Canvas& a, const Canvas& b)
{
  return a.surface.plane() && b.surface.plane() && a.number == b.number &&
         a.chart.polygon == b.chart.polygon;
}

} // namespace

/** The canvases of a polygon follow each other, row by row (\ref chartsOf); all but the last of
 * a row have the maximum size. */
Sheet::Sheet(const std::vector<Canvas>& canvases, std::size_t first, int maximum)
: canvases_(&canvases)
, first_(first)
, maximum_(maximum)
{
  const Canvas& corner = canvases[first];
  std::size_t last = first;
  while (last + 1 < canvases.size() && belongTogether(corner, canvases[last + 1]))
    ++last;
  std::size_t c = first;
  for (; c < last && isBeside(corner, canvases[c + 1]); ++c)
    width_ += maximum;
  width_ += canvases[c].chart.colors.width;
  charts_a_row_ = static_cast<std::int32_t>(c - first) + 1;
  charts_a_column_ = static_cast<std::int32_t>(last - first + 1) / charts_a_row_;
  height_ = (charts_a_column_ - 1) * maximum + canvases[last].chart.colors.height;
}

std::vector<Sheet>
sheetsOf(const std::vector<Canvas>& canvases, int maximum)
{
  std::vector<Sheet> sheets;
  for (std::size_t first = 0; first < canvases.size(); first = sheets.back().end())
    sheets.emplace_back(canvases, first, maximum);
  return sheets;
}

} // namespace pcl::acmap::texturing
