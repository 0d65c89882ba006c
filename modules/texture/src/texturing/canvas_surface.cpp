#include "texturing/canvas_surface.h"

#include <cmath>

namespace pcl::acmap::texturing {
namespace {

/** From the axis to a point, across the axis. */
Eigen::Vector3d
acrossOf(const CylinderPatch& cylinder, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d way = point - cylinder.axis_point;
  return way - way.dot(cylinder.axis_direction) * cylinder.axis_direction;
}

double
sideOf(const CylinderPatch& cylinder)
{
  return cylinder.is_hollow ? -1 : 1;
}

Eigen::AlignedBox3d
boxOf(const TextureChart& chart)
{
  Eigen::AlignedBox3d box(chart.origin);
  const Eigen::Vector3d u = chart.colors.width * chart.texel_u;
  const Eigen::Vector3d v = chart.colors.height * chart.texel_v;
  box.extend(chart.origin + u);
  box.extend(chart.origin + v);
  box.extend(chart.origin + u + v);
  return box;
}

/** Box of the whole cylinder, also of what is not in its arc. */
Eigen::AlignedBox3d
boxOf(const CylinderPatch& cylinder)
{
  Eigen::AlignedBox3d box;
  for (const double height : {cylinder.low, cylinder.high}) {
    const Eigen::Vector3d middle =
        cylinder.axis_point + height * cylinder.axis_direction;
    box.extend(middle + Eigen::Vector3d::Constant(cylinder.radius));
    box.extend(middle - Eigen::Vector3d::Constant(cylinder.radius));
  }
  return box;
}

} // namespace

CanvasSurface::CanvasSurface(const TextureChart& chart, const PlanePatch& plane)
: surface_(Rectangle{chart, plane.coefficients})
{}

CanvasSurface::CanvasSurface(const CylinderPatch& cylinder, const RgbImage& size)
: surface_(Unrolled{cylinder, Eigen::Vector2d(size.width, size.height)})
{}

double
CanvasSurface::distance(const Eigen::Vector3d& point) const
{
  if (const auto* const flat = std::get_if<Rectangle>(&surface_))
    return std::abs(flat->plane.head<3>().dot(point) + flat->plane[3]);
  const CylinderPatch& cylinder = std::get<Unrolled>(surface_).cylinder;
  return std::abs(acrossOf(cylinder, point).norm() - cylinder.radius);
}

bool
CanvasSurface::faces(const Eigen::Vector3d& eye) const
{
  if (const auto* const flat = std::get_if<Rectangle>(&surface_))
    return flat->plane.head<3>().dot(eye) + flat->plane[3] > 0;
  const CylinderPatch& cylinder = std::get<Unrolled>(surface_).cylinder;
  return cylinder.is_hollow || acrossOf(cylinder, eye).norm() > cylinder.radius;
}

bool
CanvasSurface::faces(const Eigen::Vector3d& eye, const Eigen::Vector3d& place) const
{
  constexpr double min_cosine = 0.2; // beside, pixels show what is behind the cylinder
  const Eigen::Vector3d way = eye - place;
  return std::holds_alternative<Rectangle>(surface_)
             ? faces(eye)
             : normalAt(place).dot(way) > min_cosine * way.norm();
}

Eigen::Vector3d
CanvasSurface::normalAt(const Eigen::Vector3d& place) const
{
  if (const auto* const flat = std::get_if<Rectangle>(&surface_))
    return flat->plane.head<3>();
  const CylinderPatch& cylinder = std::get<Unrolled>(surface_).cylinder;
  return sideOf(cylinder) * acrossOf(cylinder, place).normalized();
}

Eigen::Vector2d
CanvasSurface::placeOf(const Eigen::Vector3d& point) const
{
  if (const auto* const flat = std::get_if<Rectangle>(&surface_))
    return placeOn(flat->chart, point);
  const auto& [cylinder, size] = std::get<Unrolled>(surface_);
  const Eigen::Vector3d way = point - cylinder.axis_point;
  const double angle = std::atan2(way.dot(cylinder.axis_v), way.dot(cylinder.axis_u));
  const double height = way.dot(cylinder.axis_direction);
  return {(0.5 + sideOf(cylinder) * angle / cylinder.arc) * size.x(),
          (cylinder.high - height) / (cylinder.high - cylinder.low) * size.y()};
}

Eigen::Vector3d
CanvasSurface::middleOn(const Unrolled& surface, double column, double row)
{
  const auto& [cylinder, size] = surface;
  const double angle =
      sideOf(cylinder) * cylinder.arc * ((column + 0.5) / size.x() - 0.5);
  const double height =
      cylinder.high - (cylinder.high - cylinder.low) * (row + 0.5) / size.y();
  return cylinder.axis_point + height * cylinder.axis_direction +
         cylinder.radius *
             (std::cos(angle) * cylinder.axis_u + std::sin(angle) * cylinder.axis_v);
}

double
CanvasSurface::texelWidth() const
{
  if (const auto* const flat = std::get_if<Rectangle>(&surface_))
    return flat->chart.texel_u.norm();
  const auto& [cylinder, size] = std::get<Unrolled>(surface_);
  return cylinder.arc * cylinder.radius / size.x();
}

Eigen::AlignedBox3d
CanvasSurface::box() const
{
  if (const auto* const flat = std::get_if<Rectangle>(&surface_))
    return boxOf(flat->chart);
  return boxOf(std::get<Unrolled>(surface_).cylinder);
}

} // namespace pcl::acmap::texturing
