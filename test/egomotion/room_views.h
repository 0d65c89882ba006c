#pragma once

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::acmap::test {

/** \brief Brightness as a function of the position, 0 to 255: waves in space, 10 to 60
 * cm long, so that every surface is textured and looks the same from everywhere. */
class SpacePaint {
public:
  explicit SpacePaint(std::uint64_t seed, double contrast = 40);

  double
  operator()(const Eigen::Vector3d& place) const;

private:
  struct Wave {
    Eigen::Vector3d frequency; ///< radians per metre
    double phase = 0;
  };

  std::vector<Wave> waves_;
  double amplitude_;
};

using Box = Eigen::AlignedBox3d;

/** \brief A room of 6 x 2.5 x 7 metres around the origin, y down, with objects. */
struct Room {
  Box walls{Eigen::Vector3d(-3, -1.3, -2), Eigen::Vector3d(3, 1.2, 5)};
  std::vector<Box> things{
      Box(Eigen::Vector3d(-1.6, 0, 2.6), Eigen::Vector3d(-0.7, 1.2, 3.2)),
      Box(Eigen::Vector3d(0.5, 0.3, 1.9), Eigen::Vector3d(1.2, 1.2, 2.4))};
  /** Grey level of a position that is seen at a pixel. */
  std::function<double(const Eigen::Vector3d&, const Eigen::Vector2d&)> brightness;

  /** \brief A room textured with waves. */
  explicit Room(std::uint64_t seed = 1);
};

/** \brief Parameters of a view. The principal point is the centre of the image. */
struct RoomCamera {
  int width = 320, height = 240; ///< pixels
  double focal_length = 260;     ///< pixels
  double sigma = 0.002;          ///< metres along the ray at 1 m, proportional to the
                                 ///< square of the distance
  double noise = 0;              ///< factor of sigma
  std::uint64_t seed = 1;
  double gain = 1, offset = 0; ///< of the brightness
};

/** \brief First intersections of the rays, in the camera frame. */
PointCloud<PointXYZRGBSigma>::Ptr
viewOf(const Room& room,
       const Eigen::Isometry3d& T_room_camera,
       const RoomCamera& camera = {});

/** \brief Rotation about y (turn), then x (tilt), then z (roll); radians and metres. */
Eigen::Isometry3d
poseOf(const Eigen::Vector3d& place, double turn, double tilt = 0, double roll = 0);

/** \brief Two poses in the room with overlapping views. */
inline const Eigen::Isometry3d before = poseOf({-0.3, 0, -0.5}, 0.1);
inline const Eigen::Isometry3d now = before * poseOf({0.1, 0, 0.15}, 0.05);

/** \brief Small motion between two poses: tx, ty, tz in metres, rx, ry, rz in radians,
 * in the common frame of both poses. */
Eigen::Matrix<double, 6, 1>
motionBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

} // namespace pcl::acmap::test
