#include "texturing/chart_frame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::acmap::texturing {
namespace {

/** A bounding rectangle of a polygon; the axes are unit vectors in the plane. */
struct Rectangle {
  Eigen::Vector3d u, v;
  Eigen::Vector2d minimum,
      maximum; ///< bounds along u and v, relative to the centre of the
               ///< plane, in metres
  double area = 0;
};

Rectangle
rectangleAlong(const PlanePatch& plane,
               const std::vector<Eigen::Vector3f>& outer,
               const Eigen::Vector3d& u)
{
  Rectangle box;
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  box.u = u;
  box.v = u.cross(normal); // points down if u points right and the normal towards the
                           // viewer
  box.minimum.setConstant(std::numeric_limits<double>::max());
  box.maximum = -box.minimum;
  for (const Eigen::Vector3f& corner : outer) {
    const Eigen::Vector3d way = corner.cast<double>() - plane.center;
    const Eigen::Vector2d place(way.dot(box.u), way.dot(box.v));
    box.minimum = box.minimum.cwiseMin(place);
    box.maximum = box.maximum.cwiseMax(place);
  }
  box.area = (box.maximum - box.minimum).prod();
  return box;
}

/** An axis in the plane: axis_u of the plane, or any axis if that one is invalid. */
Eigen::Vector3d
axisIn(const PlanePatch& plane)
{
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  const Eigen::Vector3d axis = plane.axis_u - plane.axis_u.dot(normal) * normal;
  const bool is_one = axis.allFinite() && axis.norm() > 0.5;
  return is_one ? axis.normalized() : normal.unitOrthogonal();
}

/** The smallest of the rectangles along the edges of the polygon and along axis_u of
 * the plane; the first one of nearly equal ones. */
Rectangle
smallestRectangle(const PlanePatch& plane, const std::vector<Eigen::Vector3f>& outer)
{
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  Rectangle best = rectangleAlong(plane, outer, axisIn(plane));
  constexpr double clearly = 0.999;
  constexpr std::size_t max_tries = 500; // longer outlines have edges in all
                                         // directions
  const std::size_t step = outer.size() / max_tries + 1;
  for (std::size_t k = 0; k < outer.size(); k += step) {
    Eigen::Vector3d edge = (outer[(k + 1) % outer.size()] - outer[k]).cast<double>();
    edge -= edge.dot(normal) * normal;
    const double length = edge.norm();
    if (!(length > 1e-6))
      continue;
    const Rectangle next = rectangleAlong(plane, outer, edge / length);
    if (next.area < clearly * best.area)
      best = next;
  }
  return best;
}

/** Rotates by multiples of 90 degrees until v is as close as possible to the y axis of
 * the map (down), so that walls are upright in their images; on floors u follows the x
 * axis of the map. */
Rectangle
upright(const PlanePatch& plane,
        const std::vector<Eigen::Vector3f>& outer,
        Rectangle box)
{
  const Eigen::Vector3d normal = plane.coefficients.head<3>();
  const bool is_level = std::abs(normal.y()) > 0.7;
  Rectangle best = box;
  double best_fit = -2;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double fit = is_level ? box.u.x() : box.v.y();
    if (fit > best_fit + 1e-9) {
      best_fit = fit;
      best = box;
    }
    box = rectangleAlong(plane, outer, box.v);
  }
  return best;
}

bool
isSound(const PlanePatch& plane, const std::vector<Eigen::Vector3f>& outer)
{
  constexpr double rounding = 1e-3;
  if (outer.size() < 3 || !plane.center.allFinite() ||
      !plane.coefficients.allFinite() ||
      std::abs(plane.coefficients.head<3>().norm() - 1) > rounding)
    return false;
  return std::all_of(outer.begin(), outer.end(), [](const Eigen::Vector3f& corner) {
    return corner.allFinite();
  });
}

} // namespace

std::optional<ChartGrid>
gridOf(const PlanePatch& plane, std::size_t polygon, double texel_size)
{
  const std::vector<Eigen::Vector3f>& outer = plane.polygons[polygon].outer;
  constexpr double min_side = 1e-6; // metres
  if (!isSound(plane, outer))
    return std::nullopt;
  const Rectangle box = upright(plane, outer, smallestRectangle(plane, outer));
  const Eigen::Vector2d size = box.maximum - box.minimum;
  if (!(size.minCoeff() > min_side))
    return std::nullopt;
  const Eigen::Vector3d foot =
      plane.center -
      (plane.coefficients.head<3>().dot(plane.center) + plane.coefficients[3]) *
          plane.coefficients.head<3>();
  return ChartGrid{foot + box.minimum[0] * box.u + box.minimum[1] * box.v,
                   texel_size * box.u,
                   texel_size * box.v,
                   std::ceil(size[0] / texel_size),
                   std::ceil(size[1] / texel_size)};
}

std::vector<TextureChart>
chartsOf(const ChartGrid& grid,
         std::size_t plane_number,
         std::size_t polygon,
         int maximum)
{
  const auto columns = static_cast<std::int64_t>(grid.columns);
  const auto rows = static_cast<std::int64_t>(grid.rows);
  std::vector<TextureChart> charts;
  for (std::int64_t top = 0; top < rows; top += maximum)
    for (std::int64_t left = 0; left < columns; left += maximum) {
      TextureChart& chart = charts.emplace_back();
      chart.plane = plane_number;
      chart.polygon = polygon;
      chart.texel_u = grid.texel_u;
      chart.texel_v = grid.texel_v;
      chart.origin = grid.origin + static_cast<double>(left) * chart.texel_u +
                     static_cast<double>(top) * chart.texel_v;
      chart.colors.width =
          static_cast<std::int32_t>(std::min<std::int64_t>(maximum, columns - left));
      chart.colors.height =
          static_cast<std::int32_t>(std::min<std::int64_t>(maximum, rows - top));
    }
  return charts;
}

} // namespace pcl::acmap::texturing
