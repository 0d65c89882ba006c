#pragma once

#include <pcl/core/rig_calibration.h>

#include <array>
#include <vector>

namespace pcl::acmap {

/** \brief Where the pixels of a camera look. */
struct CameraRays {
  int width = 0;  ///< px; 0: there is no such camera
  int height = 0; ///< px
  Eigen::Isometry3d T_reference_camera = Eigen::Isometry3d::Identity();

  /** \brief A pinhole whose image holds all rays; the camera itself when it has no
   * distortion. */
  TrinocularRig pinhole;

  /** \brief x / z and y / z of each pixel, NaN where it looks nowhere; empty for the
   * pinhole itself. */
  std::vector<Eigen::Vector2d> slopes;

  /** \brief With z = 1. */
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

/** \brief By \ref RigCamera. */
using RigRays = std::array<CameraRays, 3>;

/** \throws BadArgumentException as \ref requireSoundRig */
RigRays
raysOf(const TrinocularRig& rig);

/** \brief Of cameras as they are built.
 * \throws BadArgumentException when they cannot be */
RigRays
raysOf(const RigCalibration& calibration);

} // namespace pcl::acmap
