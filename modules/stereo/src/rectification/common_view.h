#pragma once

#include <pcl/core/rig_calibration.h>

namespace pcl::acmap {

/** \brief The frame and the pinhole that all cameras of a rig are turned to. */
struct CommonView {
  /** \brief Turns directions of the reference camera's frame into the common one. */
  Eigen::Matrix3d R_common_reference = Eigen::Matrix3d::Identity();

  /** \brief Pinhole, size and baselines. */
  TrinocularRig rig;

  /** \brief Metres along x from the reference to the vertical neighbour. */
  double column_offset = 0;

  /** \brief Turns directions of a camera's frame into the common one. */
  Eigen::Matrix3d
  rotationOf(const CameraCalibration& camera) const
  {
    return R_common_reference * camera.T_reference_camera.linear();
  }
};

/** \throws BadArgumentException when no such view is in sight */
CommonView
commonViewOf(const RigCalibration& calibration);

} // namespace pcl::acmap
