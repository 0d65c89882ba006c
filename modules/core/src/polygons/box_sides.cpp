#include <pcl/core/box_sides.h>

#include <Eigen/Geometry>

#include <utility>

namespace pcl {

namespace {

/** The side at one end of an axis. */
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
  side.area = box.size[u] * box.size[v];
  const Eigen::Vector3d half_u = box.size[u] / 2 * side.axis_u;
  const Eigen::Vector3d half_v = box.size[v] / 2 * side.axis_v;
  PlanePolygon& polygon = side.polygons.emplace_back();
  for (const Eigen::Vector3d& corner : {Eigen::Vector3d(side.center - half_u - half_v),
                                        Eigen::Vector3d(side.center + half_u - half_v),
                                        Eigen::Vector3d(side.center + half_u + half_v),
                                        Eigen::Vector3d(side.center - half_u + half_v)})
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
  if (!box.axes.allFinite() || !(reach < largest))
    return sides;
  for (std::size_t i = 0; i < box.faces.size(); ++i)
    if (box.faces[i].kind == BoxFaceKind::Free)
      sides.push_back(sideOf(box, static_cast<Eigen::Index>(i / 2), i % 2 == 0));
  return sides;
}

} // namespace pcl
