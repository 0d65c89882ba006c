#include "box_scenes.h"

#include <algorithm>
#include <cmath>

namespace pcl::acmap::test {

namespace {

Eigen::Vector3f
moved(const Eigen::Vector3f& point, const Eigen::Isometry3d& T_b_a)
{
  return (T_b_a * point.cast<double>()).cast<float>();
}

} // namespace

std::int32_t
RectangleMap::add(const Eigen::Vector3d& corner,
                  const Eigen::Vector3d& edge_u,
                  const Eigen::Vector3d& edge_v)
{
  constexpr double points_per_area = 500, sigma = 0.01;
  PlanePatch plane;
  const Eigen::Vector3d normal = edge_u.cross(edge_v).normalized();
  plane.center = corner + (edge_u + edge_v) / 2;
  plane.coefficients << normal, -normal.dot(plane.center);
  plane.axis_u = edge_u.normalized();
  plane.axis_v = edge_v.normalized();
  plane.area = edge_u.norm() * edge_v.norm();
  plane.effective_support = points_per_area * plane.area;
  plane.support = static_cast<std::size_t>(plane.effective_support);
  plane.rms = sigma;
  const double variance = sigma * sigma / plane.effective_support;
  plane.covariance.diagonal() << 12 * variance / edge_u.squaredNorm(),
      12 * variance / edge_v.squaredNorm(), variance;
  PlanePolygon polygon;
  for (const Eigen::Vector3d& point : {corner,
                                       Eigen::Vector3d(corner + edge_u),
                                       Eigen::Vector3d(corner + edge_u + edge_v),
                                       Eigen::Vector3d(corner + edge_v)})
    polygon.outer.push_back(point.cast<float>());
  plane.polygons.push_back(polygon);
  planes.push_back(plane);
  return static_cast<std::int32_t>(planes.size()) - 1;
}

void
RectangleMap::addBox(const Eigen::Vector3d& least,
                     const Eigen::Vector3d& most,
                     const std::string& faces)
{
  const Eigen::Matrix3d edges = (most - least).asDiagonal();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d u = edges.col((axis + 1) % 3), v = edges.col((axis + 2) % 3);
    const std::string name(1, static_cast<char>('x' + axis));
    if (faces.find('+' + name) != std::string::npos)
      add(most - u - v, u, v);
    if (faces.find('-' + name) != std::string::npos)
      add(least, v, u);
  }
}

void
RectangleMap::addRoom(const Eigen::Vector3d& least, const Eigen::Vector3d& most)
{
  RectangleMap room;
  room.addBox(least, most, "+x-x+y-y+z-z");
  room.turnInsideOut();
  planes.insert(planes.end(), room.planes.begin(), room.planes.end());
}

void
RectangleMap::turnInsideOut()
{
  for (PlanePatch& plane : planes) {
    plane.coefficients *= -1;
    std::swap(plane.axis_u, plane.axis_v);
    plane.covariance.row(0).swap(plane.covariance.row(1));
    plane.covariance.col(0).swap(plane.covariance.col(1));
    for (PlanePolygon& polygon : plane.polygons)
      std::reverse(polygon.outer.begin(), polygon.outer.end());
  }
}

std::vector<PlanePatch>
transformed(std::vector<PlanePatch> planes, const Eigen::Isometry3d& T_b_a)
{
  for (PlanePatch& plane : planes) {
    plane.center = T_b_a * plane.center;
    plane.axis_u = T_b_a.linear() * plane.axis_u;
    plane.axis_v = T_b_a.linear() * plane.axis_v;
    const Eigen::Vector3d normal =
        T_b_a.linear() * Eigen::Vector3d(plane.coefficients.head<3>());
    plane.coefficients << normal, -normal.dot(plane.center);
    for (PlanePolygon& polygon : plane.polygons)
      for (Eigen::Vector3f& point : polygon.outer)
        point = moved(point, T_b_a);
  }
  return planes;
}

std::vector<PlanePatch>
disturbed(std::vector<PlanePatch> planes, Random& random, double factor)
{
  for (PlanePatch& plane : planes) {
    const Eigen::Vector3d error =
        factor * Eigen::Vector3d(std::sqrt(plane.covariance(0, 0)) * random.normal(),
                                 std::sqrt(plane.covariance(1, 1)) * random.normal(),
                                 std::sqrt(plane.covariance(2, 2)) * random.normal());
    const Eigen::Vector3d old = plane.coefficients.head<3>();
    const Eigen::Vector3d normal =
        (old - error[0] * plane.axis_u - error[1] * plane.axis_v).normalized();
    plane.center += error[2] * old;
    plane.coefficients << normal, -normal.dot(plane.center);
    plane.axis_u = (plane.axis_u - plane.axis_u.dot(normal) * normal).normalized();
    plane.axis_v = normal.cross(plane.axis_u);
    for (PlanePolygon& polygon : plane.polygons)
      for (Eigen::Vector3f& point : polygon.outer) {
        const double height = normal.dot(point.cast<double>()) + plane.coefficients[3];
        point -= (height * normal).cast<float>();
      }
  }
  return planes;
}

} // namespace pcl::acmap::test
