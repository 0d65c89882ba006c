#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** One view of a room as a depth camera sees it: a floor, a back wall and a side wall, with
 * a box before them. Camera frame, metres, row by row. */
struct DepthRoom {
  static constexpr std::size_t width = 320, height = 240;
  static constexpr double focal = 262.5;

  /** How the camera errs, in 1/m of inverse depth. */
  struct Camera {
    double step = 0.0029;      ///< rounding, that of a Kinect; 0 for none
    double independent = 3e-4; ///< a pixel's own noise
    double correlated = 6e-4;  ///< what 7 x 7 pixels share
    std::uint64_t seed = 1;
  };

  /** A plane of the room: normal . X = distance, the normal away from the camera. */
  struct Plane {
    Eigen::Vector3d normal;
    double distance;
  };

  explicit DepthRoom(const Camera& camera);

  std::vector<Plane> planes; ///< back wall, side wall, floor, front, top of the box
  std::vector<std::int32_t> truth; ///< for each pixel its plane
  std::vector<Eigen::Vector3f> points;
  std::vector<double> true_depths; ///< metres
};

/** A cylinder that stands before the camera, with its axis along y: no plane. */
std::vector<Eigen::Vector3f>
depthOfCylinder(const DepthRoom::Camera& camera, double radius, double distance);

} // namespace pcl::acmap::test
