#include "comparison/plane_overlap.h"

namespace pcl::acmap {

namespace {

/** \brief Signed area of a triangle; negative if it is clockwise seen from the side of
 * the normal. */
double
areaOf(const Eigen::Vector3d& a,
       const Eigen::Vector3d& b,
       const Eigen::Vector3d& c,
       const Eigen::Vector3d& normal)
{
  return (b - a).cross(c - a).dot(normal) / 2;
}

/** \brief Adds a convex polygon; `middle` is a weighted sum until all polygons are
 * added. */
void
add(const std::vector<ChartCorner>& polygon,
    const Eigen::Vector3d& normal,
    PlaneOverlap& overlap)
{
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Eigen::Vector3d& a = polygon[0].point;
    const Eigen::Vector3d& b = polygon[i - 1].point;
    const Eigen::Vector3d& c = polygon[i].point;
    const double area = areaOf(a, b, c, normal);
    overlap.area += area;
    overlap.middle += area * (a + b + c) / 3;
  }
}

void
addFan(const std::vector<Eigen::Vector3f>& loop,
       const Eigen::Isometry3d& T_truth_map,
       PlacedPlane& plane)
{
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& point : loop)
    points.push_back(T_truth_map * point.cast<double>());
  for (std::size_t i = 2; i < points.size(); ++i) {
    plane.fans.push_back({points[0], points[i - 1], points[i]});
    plane.area +=
        areaOf(points[0], points[i - 1], points[i], plane.coefficients.head<3>());
  }
}

} // namespace

PlacedPlane
placed(const PlanePatch& plane, const Eigen::Isometry3d& T_truth_map)
{
  PlacedPlane result;
  const Eigen::Vector3d normal = T_truth_map.linear() * plane.coefficients.head<3>();
  const double offset = plane.coefficients[3] - normal.dot(T_truth_map.translation());
  result.coefficients << normal, offset;
  for (const PlanePolygon& polygon : plane.polygons) {
    addFan(polygon.outer, T_truth_map, result);
    for (const auto& hole : polygon.holes)
      addFan(hole, T_truth_map, result);
  }
  return result;
}

PlaneOverlap
overlapOf(const PlacedPlane& found, const TruePlane& truth)
{
  PlaneOverlap overlap;
  for (const ChartClip& rectangle : truth.rectangles)
    for (const auto& triangle : found.fans)
      add(rectangle.clipped(triangle), found.coefficients.head<3>(), overlap);
  if (overlap.area > 0)
    overlap.middle /= overlap.area;
  return overlap;
}

} // namespace pcl::acmap
