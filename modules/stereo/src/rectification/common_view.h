#pragma once

#include <pcl/core/rig_calibration.h>

namespace pcl::acmap {

/** \brief The frame and the pinhole that are common to all cameras of a rig. */
struct CommonView {
  /** \brief Rotates directions from the frame of the reference camera to the common
   * one. */
  Eigen::Matrix3d R_common_reference = Eigen::Matrix3d::Identity();

  /** \brief Pinhole, size and baselines. */
  TrinocularRig rig;

  /** \brief Metres along x from the reference to the vertical neighbour. */
  double column_offset = 0;

  /** \brief Rotates directions from the frame of a camera to the common one. */
  Eigen::Matrix3d
  rotationOf(const CameraCalibration& camera) const
  {
    return R_common_reference * camera.T_reference_camera.linear();
  }
};

/** \throws BadArgumentException when there is no such view */
CommonView
commonViewOf(const RigCalibration& calibration);

} // namespace pcl::acmap
