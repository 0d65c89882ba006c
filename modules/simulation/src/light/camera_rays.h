#pragma once

#include <pcl/core/rig_calibration.h>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief Viewing rays of the pixels of a camera. */
struct CameraRays {
  int width = 0;  ///< px; 0: there is no such camera
  int height = 0; ///< px
  Eigen::Isometry3d T_reference_camera = Eigen::Isometry3d::Identity();

  /** \brief A pinhole whose image contains all rays; the camera itself if it has no
   * distortion. */
  TrinocularRig pinhole;

  /** \brief x / z and y / z of each pixel, NaN if it has no ray; empty for the pinhole
   * itself. */
  std::vector<Eigen::Vector2d> slopes;

  /** \brief Ray of a pixel with z = 1. */
  Eigen::Vector3d
  ray(int column, int row) const
  {
    if (slopes.empty())
      return {(column - pinhole.center_x) / pinhole.focal_length,
              (row - pinhole.center_y) / pinhole.focal_length,
              1.0};
    return slopes[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)]
        .homogeneous();
  }
};

/** \brief Rays of the cameras, indexed by \ref RigCamera. */
using RigRays = std::array<CameraRays, 3>;

/** \throws BadArgumentException as \ref requireSoundRig */
RigRays
raysOf(const TrinocularRig& rig);

/** \brief Rays of unrectified cameras.
 * \throws BadArgumentException for an invalid calibration */
RigRays
raysOf(const RigCalibration& calibration);

} // namespace pcl::acmap
