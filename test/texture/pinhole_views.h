#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <vector>

namespace pcl::acmap::test {

using Rgb = std::array<double, 3>;

/** \brief A coloured parallelogram that cameras see. */
struct Screen {
  Eigen::Vector3d corner, u, v;
  std::function<Rgb(const Eigen::Vector3d&)> color;
};

/** \brief Edge of the squares of the wall and of the floor, metres. */
constexpr double square = 0.1;

Rgb
wallColor(const Eigen::Vector3d& place);

Rgb
floorColor(const Eigen::Vector3d& place);

/** \brief z = 3, 3 m wide and 2.4 m high, seen from the origin; the floor before it, 1.2 m
 * below and 2 m deep; all else is far away and magenta, a colour of neither. y is down. */
std::vector<Screen>
wallAndFloor();

/** \brief Their planes: wall, floor. */
std::vector<PlanePatch>
planesOfWallAndFloor();

/** \brief A plane with one polygon of these corners. */
PlanePatch
makePlane(const Eigen::Vector3d& normal, const std::vector<Eigen::Vector3f>& corners);

/** \brief What a camera saw. */
struct View {
  PointCloud<PointXYZRGB>::Ptr cloud; ///< 240 x 180, camera frame
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
};

/** \brief A camera's place and where it looks. */
struct Shot {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  double yaw = 0;        ///< radians, to the right
  double pitch = 0;      ///< radians, up
  double brightness = 1; ///< factor of all colours
};

/** \brief Exact depths and colours of the nearest screens at each pixel; NaN and black where
 * there is none. */
View
lookAt(const std::vector<Screen>& screens, const Shot& shot = {});

/** \brief The points of a view in the map's frame, without their order. */
View
scattered(const View& view);

} // namespace pcl::acmap::test
