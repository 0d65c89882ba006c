#include "depth/tile_moments.h"

#include <cmath>

namespace pcl::acmap::depth {

InverseFit
fitInverse(const Moments& m)
{
  const double xm = m.x / m.count, ym = m.y / m.count, um = m.z / m.count;
  const double xx = m.xx / m.count - xm * xm, xy = m.xy / m.count - xm * ym;
  const double yy = m.yy / m.count - ym * ym, xu = m.xz / m.count - xm * um;
  const double yu = m.yz / m.count - ym * um, uu = m.zz / m.count - um * um;
  InverseFit fit;
  const double determinant = xx * yy - xy * xy;
  constexpr double line = 1e-9; // pixels of one row only define one slope
  double a = 0, b = 0;
  if (determinant > line * (xx + yy) * (xx + yy)) {
    a = (xu * yy - yu * xy) / determinant;
    b = (yu * xx - xu * xy) / determinant;
  }
  fit.plane = {a, b, um - a * xm - b * ym};
  fit.rms = std::sqrt(std::max(uu - a * xu - b * yu, 0.0));
  return fit;
}

Residual
residualOf(const Moments& m, const InversePlane& plane)
{
  const double a = plane[0], b = plane[1], c = plane[2];
  Residual residual;
  residual.mean = (m.z - a * m.x - b * m.y - c * m.count) / m.count;
  // about the centre of the tile, where the squares are small
  const double xm = m.x / m.count, ym = m.y / m.count, um = m.z / m.count;
  const double xx = m.xx / m.count - xm * xm, xy = m.xy / m.count - xm * ym;
  const double yy = m.yy / m.count - ym * ym, xu = m.xz / m.count - xm * um;
  const double yu = m.yz / m.count - ym * um, uu = m.zz / m.count - um * um;
  const double spread =
      uu + a * a * xx + b * b * yy + 2 * (a * b * xy - a * xu - b * yu);
  residual.rms = std::sqrt(std::max(spread, 0.0) + residual.mean * residual.mean);
  return residual;
}

TileMoments::TileMoments(const DepthView& view, std::size_t edge)
: edge_(edge)
, columns_((view.width() + edge - 1) / edge)
, rows_((view.height() + edge - 1) / edge)
, tiles_(columns_ * rows_)
{
  for (std::size_t row = 0, pixel = 0; row < view.height(); ++row) {
    Moments* const tiles = &tiles_[row / edge * columns_];
    for (std::size_t tile = 0, column = 0; tile < columns_; ++tile) {
      Moments& sum = tiles[tile];
      const double y = view.rayOf(0, row).y();
      double n = 0, x1 = 0, u1 = 0, x2 = 0, xu = 0, u2 = 0;
      for (const std::size_t end = std::min(column + edge, view.width()); column < end;
           ++column, ++pixel) {
        const double u = static_cast<double>(view.inverseDepth(pixel));
        if (!(u > 0))
          continue;
        const double x = view.rayOf(column, 0).x();
        n += 1;
        x1 += x;
        u1 += u;
        x2 += x * x;
        xu += x * u;
        u2 += u * u;
      }
      sum += Moments{n, x1, n * y, u1, x2, x1 * y, xu, n * y * y, u1 * y, u2};
    }
  }
}

} // namespace pcl::acmap::depth
