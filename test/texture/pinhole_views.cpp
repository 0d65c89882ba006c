#include "pinhole_views.h"

#include <cmath>
#include <limits>
#include <optional>

namespace pcl::acmap::test {
namespace {

constexpr int width = 240, height = 180;
constexpr double focal_length = 210;

bool
isEven(double a, double b)
{
  return std::fmod(std::floor(a / square) + std::floor(b / square) + 1000, 2) == 0;
}

/** Intersection of a ray with a screen, as a multiple of its direction. */
std::optional<double>
meet(const Screen& screen, const Eigen::Vector3d& eye, const Eigen::Vector3d& ray)
{
  Eigen::Matrix3d basis;
  basis << screen.u, screen.v, -ray;
  const Eigen::Vector3d s = basis.inverse() * (eye - screen.corner);
  if (s[0] < 0 || s[0] > 1 || s[1] < 0 || s[1] > 1 || !(s[2] > 0))
    return std::nullopt;
  return s[2];
}

} // namespace

Rgb
wallColor(const Eigen::Vector3d& place)
{
  return isEven(place.x(), place.y()) ? Rgb{200, 120, 60} : Rgb{60, 110, 180};
}

Rgb
floorColor(const Eigen::Vector3d& place)
{
  return isEven(place.x(), place.z()) ? Rgb{40, 160, 80} : Rgb{160, 220, 90};
}

std::vector<Screen>
wallAndFloor()
{
  return {{{-1.5, -1.2, 3}, {3, 0, 0}, {0, 2.4, 0}, wallColor},
          {{-1.5, 1.2, 1}, {3, 0, 0}, {0, 0, 2}, floorColor},
          {{-40, -40, 9}, {80, 0, 0}, {0, 80, 0}, [](const auto&) {
             return Rgb{255, 0, 255};
           }}};
}

PlanePatch
makePlane(const Eigen::Vector3d& normal, const std::vector<Eigen::Vector3f>& corners)
{
  PlanePatch plane;
  plane.polygons.resize(1);
  plane.polygons[0].outer = corners;
  if (!corners.empty())
    plane.center = corners.front().cast<double>();
  plane.coefficients << normal, -normal.dot(plane.center);
  plane.axis_u = normal.unitOrthogonal();
  plane.axis_v = normal.cross(plane.axis_u);
  return plane;
}

std::vector<PlanePatch>
planesOfWallAndFloor()
{
  return {makePlane(
              {0, 0, -1},
              {{-1.5F, -1.2F, 3}, {-1.5F, 1.2F, 3}, {1.5F, 1.2F, 3}, {1.5F, -1.2F, 3}}),
          makePlane(
              {0, -1, 0},
              {{-1.5F, 1.2F, 3}, {-1.5F, 1.2F, 1}, {1.5F, 1.2F, 1}, {1.5F, 1.2F, 3}})};
}

View
lookAt(const std::vector<Screen>& screens, const Shot& shot)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  View view;
  view.T_map_camera.translation() = shot.eye;
  view.T_map_camera.linear() = (Eigen::AngleAxisd(shot.yaw, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(shot.pitch, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  view.cloud.reset(new PointCloud<PointXYZRGB>(width, height));
  view.cloud->is_dense = false;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Eigen::Vector3d in_camera((column - (width - 1) / 2.0) / focal_length,
                                      (row - (height - 1) / 2.0) / focal_length,
                                      1);
      const Eigen::Vector3d ray = view.T_map_camera.linear() * in_camera;
      PointXYZRGB& point = view.cloud->at(column, row);
      point = PointXYZRGB(nan, nan, nan, 0, 0, 0);
      double minimum = std::numeric_limits<double>::max();
      for (const Screen& screen : screens) {
        const std::optional<double> depth = meet(screen, shot.eye, ray);
        if (!depth || *depth >= minimum)
          continue;
        minimum = *depth;
        const Rgb color = screen.color(shot.eye + *depth * ray);
        point.getVector3fMap() = (*depth * in_camera).cast<float>();
        point.r = static_cast<std::uint8_t>(std::lround(color[0] * shot.brightness));
        point.g = static_cast<std::uint8_t>(std::lround(color[1] * shot.brightness));
        point.b = static_cast<std::uint8_t>(std::lround(color[2] * shot.brightness));
      }
    }
  return view;
}

View
scattered(const View& view)
{
  View points;
  points.cloud.reset(new PointCloud<PointXYZRGB>);
  for (const PointXYZRGB& point : *view.cloud) {
    points.cloud->push_back(point);
    points.cloud->back().getVector3fMap() =
        (view.T_map_camera * point.getVector3fMap().cast<double>()).cast<float>();
  }
  return points;
}

} // namespace pcl::acmap::test
