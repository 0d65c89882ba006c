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

/** \brief A coloured parallelogram. */
struct Screen {
  Eigen::Vector3d corner, u, v;
  std::function<Rgb(const Eigen::Vector3d&)> color;
};

/** \brief Edge length of the squares on wall and floor, metres. */
constexpr double square = 0.1;

Rgb
wallColor(const Eigen::Vector3d& place);

Rgb
floorColor(const Eigen::Vector3d& place);

/** \brief The wall z = 3, 3 m wide and 2.4 m high, seen from the origin; the floor in
 * front of it, 1.2 m below and 2 m deep; the background is far away and magenta, a
 * colour that neither has. y is down. */
std::vector<Screen>
wallAndFloor();

/** \brief Their planes: wall, floor. */
std::vector<PlanePatch>
planesOfWallAndFloor();

/** \brief A plane with one polygon of these corners. */
PlanePatch
makePlane(const Eigen::Vector3d& normal, const std::vector<Eigen::Vector3f>& corners);

/** \brief View of a simulated camera. */
struct View {
  PointCloud<PointXYZRGB>::Ptr cloud; ///< 240 x 180, camera frame
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
};

/** \brief Pose and exposure of a camera. */
struct Shot {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  double yaw = 0;        ///< radians, to the right
  double pitch = 0;      ///< radians, up
  double brightness = 1; ///< factor for all colours
};

/** \brief Exact depths and colours of the nearest screen at each pixel; NaN and black
 * if there is none. */
View
lookAt(const std::vector<Screen>& screens, const Shot& shot = {});

/** \brief The points of a view in the frame of the map, as an unorganized cloud. */
View
scattered(const View& view);

} // namespace pcl::acmap::test
