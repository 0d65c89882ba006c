#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl::acmap::test {

/** A simulated depth image of a room: a floor, a back wall and a side wall, with a box
 * in front. Camera frame, metres, in row-major order. */
struct DepthRoom {
  static constexpr std::size_t width = 320, height = 240;
  static constexpr double focal = 262.5;

  /** Errors of the camera, in 1/m of inverse depth. */
  struct Camera {
    double step = 0.0029;      ///< quantization, as of a Kinect; 0 for none
    double independent = 3e-4; ///< noise that is independent for each pixel
    double correlated = 6e-4;  ///< noise that is shared by 7 x 7 pixels
    std::uint64_t seed = 1;
  };

  /** A plane of the room: normal . X = distance, with the normal pointing away from the
   * camera. */
  struct Plane {
    Eigen::Vector3d normal;
    double distance;
  };

  explicit DepthRoom(const Camera& camera);

  std::vector<Plane> planes; ///< back wall, side wall, floor, front, top of the box
  std::vector<std::int32_t> truth; ///< plane of each pixel
  std::vector<Eigen::Vector3f> points;
  std::vector<double> true_depths; ///< metres
};

/** A cylinder in front of the camera, with its axis along y: there is no plane. */
std::vector<Eigen::Vector3f>
depthOfCylinder(const DepthRoom::Camera& camera, double radius, double distance);

} // namespace pcl::acmap::test
