#include "cast_target.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace pcl::acmap {

namespace {

using Polygon = std::vector<Eigen::Vector3d>;

constexpr double edge_slack = 1e-9; // metres

/** \brief The part of a convex polygon where sign * (z - depth) >= 0. */
Polygon
clipped(const Polygon& polygon, double depth, double sign)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d& a = polygon[i];
    const Eigen::Vector3d& b = polygon[(i + 1) % polygon.size()];
    const double at_a = sign * (a.z() - depth);
    const double at_b = sign * (b.z() - depth);
    if (at_a >= 0.0)
      kept.push_back(a);
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0))
      kept.emplace_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return kept;
}

/** \brief Bounding box of the projections of points in front of the camera, enlarged by
 * one pixel. */
std::optional<PixelBox>
boxOf(const Polygon& points, const TrinocularRig& rig)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::Array2d minimum(infinity, infinity);
  Eigen::Array2d maximum = -minimum;
  const Eigen::Array2d center(rig.center_x, rig.center_y);
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Array2d pixel =
        rig.focal_length * point.head<2>().array() / point.z() + center;
    minimum = minimum.min(pixel);
    maximum = maximum.max(pixel);
  }
  const Eigen::Array2d last(rig.width - 1, rig.height - 1);
  minimum = (minimum.floor() - 1.0).max(0.0);
  maximum = (maximum.ceil() + 1.0).min(last);
  if ((minimum > maximum).any())
    return {};
  const Eigen::Array2i first = minimum.cast<int>();
  const Eigen::Array2i end = maximum.cast<int>();
  return PixelBox{first.x(), end.x(), first.y(), end.y()};
}

std::optional<PixelBox>
boxOfPolygon(const Polygon& polygon, const TrinocularRig& rig, const DepthRange& range)
{
  const Polygon before =
      clipped(clipped(polygon, range.minimum, 1.0), range.maximum, -1.0);
  return before.empty() ? std::nullopt : boxOf(before, rig);
}

/** \brief Two unit vectors orthogonal to a unit vector and to each other. */
std::array<Eigen::Vector3d, 2>
across(const Eigen::Vector3d& axis)
{
  const Eigen::Vector3d first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

Polygon
squareAround(const Eigen::Vector3d& center,
             const Eigen::Vector3d& normal,
             double radius)
{
  const auto [u, v] = across(normal);
  return {center + radius * (u + v),
          center + radius * (v - u),
          center - radius * (u + v),
          center + radius * (u - v)};
}

/** \brief Transforms a shape to the camera frame and determines the pixels that it
 * covers. */
class TargetCamera {
public:
  TargetCamera(const TrinocularRig& rig,
               const Eigen::Isometry3d& T_camera_scene,
               const DepthRange& range)
  : rig_(rig)
  , T_camera_scene_(T_camera_scene)
  , range_(range)
  {}

  std::optional<CastTarget>
  operator()(const SimulatedRectangle& rectangle) const
  {
    const Eigen::Vector3d c = T_camera_scene_ * rectangle.corner;
    const Eigen::Vector3d u = T_camera_scene_.linear() * rectangle.edge_u;
    const Eigen::Vector3d v = T_camera_scene_.linear() * rectangle.edge_v;
    const auto box = boxOfPolygon({c, c + u, c + u + v, c + v}, rig_, range_);
    if (!box)
      return {};
    RectangleTarget target;
    target.normal = u.cross(v).normalized();
    target.offset = target.normal.dot(c);
    target.u_axis = (target.offset * u - c.dot(u) * target.normal) / u.squaredNorm();
    target.v_axis = (target.offset * v - c.dot(v) * target.normal) / v.squaredNorm();
    target.u_slack = edge_slack / u.norm();
    target.v_slack = edge_slack / v.norm();
    return CastTarget{-1, *box, target};
  }

  std::optional<CastTarget>
  operator()(const SimulatedDisc& disc) const
  {
    const Eigen::Vector3d normal = T_camera_scene_.linear() * disc.normal;
    const Eigen::Vector3d center = T_camera_scene_ * disc.center;
    const auto box =
        boxOfPolygon(squareAround(center, normal, disc.radius), rig_, range_);
    if (!box)
      return {};
    return CastTarget{-1, *box, DiscTarget{normal, center, disc.radius}};
  }

  std::optional<CastTarget>
  operator()(const SimulatedCylinder& cylinder) const
  {
    const double length = cylinder.axis.norm();
    const Eigen::Vector3d axis = T_camera_scene_.linear() * cylinder.axis / length;
    const Eigen::Vector3d base = T_camera_scene_ * cylinder.base;
    const CylinderTarget target{base, axis, length, cylinder.radius};
    Polygon around = squareAround(base, axis, cylinder.radius);
    const Polygon top = squareAround(base + length * axis, axis, cylinder.radius);
    around.insert(around.end(), top.begin(), top.end());
    const auto [nearest, farthest] =
        std::minmax_element(around.begin(),
                            around.end(),
                            [](const auto& a, const auto& b) { return a.z() < b.z(); });
    if (farthest->z() < range_.minimum || nearest->z() > range_.maximum)
      return {};
    // A cylinder that reaches behind the camera is tested for all pixels; this is rare.
    const PixelBox everywhere{0, rig_.width - 1, 0, rig_.height - 1};
    const auto box = nearest->z() < range_.minimum ? everywhere : boxOf(around, rig_);
    if (!box)
      return {};
    return CastTarget{-1, *box, target};
  }

private:
  const TrinocularRig& rig_;
  const Eigen::Isometry3d& T_camera_scene_;
  const DepthRange& range_;
};

} // namespace

std::optional<CastTarget>
targetOf(const SimulatedSurface& surface,
         std::int32_t index,
         const TrinocularRig& rig,
         const Eigen::Isometry3d& T_camera_scene,
         const DepthRange& range)
{
  auto target = std::visit(TargetCamera(rig, T_camera_scene, range), surface.shape);
  if (target)
    target->surface = index;
  return target;
}

} // namespace pcl::acmap
