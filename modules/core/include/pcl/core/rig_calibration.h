#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>
#include <pcl/core/trinocular_frame.h>
#include <pcl/core/trinocular_rig.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <string>

namespace pcl {

/** \brief Calibration of one camera before rectification. \ingroup core */
struct CameraCalibration {
  double focal_x = 520.0;  ///< px, in units of the pixel width
  double focal_y = 520.0;  ///< px, in units of the pixel height
  double center_x = 319.5; ///< px, of the principal point
  double center_y = 239.5; ///< px

  /** \brief k1, k2, p1, p2, k3 of the Brown-Conrady model, in the order of OpenCV. */
  std::array<double, 5> distortion{0, 0, 0, 0, 0};

  /** \brief Pose of this camera in the frame of the reference camera, metres. */
  Eigen::Isometry3d T_reference_camera = Eigen::Isometry3d::Identity();

  bool is_there = false;
};

/** \brief Calibration of the cameras of a rig before rectification. The
 * \ref TrinocularRig after rectification follows from it. \ingroup core */
struct RigCalibration {
  int width = 640;  ///< px
  int height = 480; ///< px

  /** \brief Indexed by \ref RigCamera. The reference camera always exists, and its pose
   * is the identity. */
  std::array<CameraCalibration, 3> cameras;

  CameraCalibration&
  camera(RigCamera camera)
  {
    return cameras[static_cast<std::size_t>(camera)];
  }

  const CameraCalibration&
  camera(RigCamera camera) const
  {
    return cameras[static_cast<std::size_t>(camera)];
  }
};

/** \brief Checks the calibration of a rig. Rejects a missing reference camera or one
 * whose pose is not the identity, a size beyond 32768 px, values that are not finite, a
 * focal length below 1 px, a pose that is not a rigid motion or is more than 100 m
 * away.
 * \throws BadArgumentException naming camera, value and legal range \ingroup core */
ACMAP_EXPORT void
requireSoundCalibration(const RigCalibration& calibration);

/** \brief Returns the unit ray of a pixel in the frame of its camera; the distortion is
 * removed iteratively.
 * \return NaN if the distortion cannot be inverted near the pixel \ingroup core */
ACMAP_EXPORT Eigen::Vector3d
pixelRay(const CameraCalibration& camera, const Eigen::Vector2d& pixel);

/** \brief Projects a point into a camera, px.
 * \param[in] point metres, in the frame of this camera, in front of it (z > 0)
 * \ingroup core */
ACMAP_EXPORT Eigen::Vector2d
projectPoint(const CameraCalibration& camera, const Eigen::Vector3d& point);

/** \brief Returns the calibration of a rectified rig: cameras without distortion,
 * placed along its baselines. \ingroup core */
ACMAP_EXPORT RigCalibration
calibrationOf(const TrinocularRig& rig);

/** \brief Reads the cameras from a `rig.yaml`; see doc/core/rig_calibration.md.
 * \throws InputFileException naming file, line, key and value; also when the file has
 * only a rectified rig, or a rig of other cameras \ingroup core */
ACMAP_EXPORT RigCalibration
loadRigCalibration(const std::string& path);

/** \brief Writes a `rig.yaml` with the rectified rig and the calibration of its
 * cameras.
 * \throws BadArgumentException for an invalid rig or calibration
 * \throws OutputFileException when the file could not be written completely
 * \ingroup core */
ACMAP_EXPORT void
saveRigCalibration(const std::string& path,
                   const TrinocularRig& rig,
                   const RigCalibration& calibration);

} // namespace pcl
