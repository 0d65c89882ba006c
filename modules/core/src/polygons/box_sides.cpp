#include <pcl/core/box_sides.h>

#include <Eigen/Geometry>

#include <utility>

namespace pcl {

namespace {

/** The part of a convex polygon behind a plane. */
std::vector<Eigen::Vector3d>
behind(const Eigen::Vector4d& plane, const std::vector<Eigen::Vector3d>& corners)
{
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const double before = plane.head<3>().dot(from) + plane[3],
                 after = plane.head<3>().dot(to) + plane[3];
    if (before <= 0)
      kept.push_back(from);
    if ((before <= 0) != (after <= 0))
      kept.push_back(from + before / (before - after) * (to - from));
  }
  return kept;
}

/** Twice the area of a polygon, along its normal. */
Eigen::Vector3d
twiceArea(const std::vector<Eigen::Vector3d>& corners)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  return sum;
}

/** The side at one end of an axis, as far as it is behind the slanted side. */
PlanePatch
sideOf(const BoxPatch& box, Eigen::Index axis, bool is_far)
{
  PlanePatch side;
  const double sign = is_far ? 1 : -1;
  const Eigen::Vector3d normal = sign * box.axes.col(axis);
  Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (!is_far)
    std::swap(u, v);
  side.axis_u = box.axes.col(u);
  side.axis_v = box.axes.col(v);
  side.center = box.center + box.size[axis] / 2 * normal;
  side.coefficients << normal, -normal.dot(side.center);
  const Eigen::Vector3d half_u = box.size[u] / 2 * side.axis_u;
  const Eigen::Vector3d half_v = box.size[v] / 2 * side.axis_v;
  const std::vector<Eigen::Vector3d> corners = behind(box.slant,
                                                      {side.center - half_u - half_v,
                                                       side.center + half_u - half_v,
                                                       side.center + half_u + half_v,
                                                       side.center - half_u + half_v});
  side.area = normal.dot(twiceArea(corners)) / 2;
  PlanePolygon& polygon = side.polygons.emplace_back();
  for (const Eigen::Vector3d& corner : corners)
    polygon.outer.push_back(corner.cast<float>());
  return side;
}

} // namespace

std::vector<PlanePatch>
freeSidesOf(const BoxPatch& box)
{
  std::vector<PlanePatch> sides;
  const double reach = box.center.cwiseAbs().maxCoeff() + box.size.cwiseAbs().sum();
  constexpr double largest = 1e38; // of a float
  if (!box.axes.allFinite() || !box.slant.allFinite() || !(reach < largest))
    return sides;
  for (std::size_t i = 0; i < box.faces.size(); ++i)
    if (box.faces[i].kind == BoxFaceKind::Free) {
      PlanePatch side = sideOf(box, static_cast<Eigen::Index>(i / 2), i % 2 == 0);
      if (side.area > 0)
        sides.push_back(std::move(side));
    }
  return sides;
}

} // namespace pcl
