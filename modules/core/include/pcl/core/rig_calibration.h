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

/** \brief A camera as it is built, before rectification. \ingroup core */
struct CameraCalibration {
  double focal_x = 520.0;  ///< px, a pixel's width
  double focal_y = 520.0;  ///< px, a pixel's height
  double center_x = 319.5; ///< px, of the principal point
  double center_y = 239.5; ///< px

  /** \brief k1, k2, p1, p2, k3 of the Brown-Conrady model, as OpenCV orders them. */
  std::array<double, 5> distortion{0, 0, 0, 0, 0};

  /** \brief Place of this camera in the frame of the reference camera, metres. */
  Eigen::Isometry3d T_reference_camera = Eigen::Isometry3d::Identity();

  bool is_there = false;
};

/** \brief The cameras of a rig as they are built. What a \ref TrinocularRig has after
 * rectification follows from it. \ingroup core */
struct RigCalibration {
  int width = 640;  ///< px
  int height = 480; ///< px

  /** \brief By \ref RigCamera; the reference is always there, its place the identity. */
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

/** \brief Refuses cameras that no rig can have: no reference or one whose place is not
 * the identity, a size beyond 32768 px, what is not finite, a focal length below 1 px, a
 * place that is no rigid motion or more than 100 m away.
 * \throws BadArgumentException naming camera, value and legal range \ingroup core */
ACMAP_EXPORT void
requireSoundCalibration(const RigCalibration& calibration);

/** \brief The unit ray a pixel looks along, in the frame of its camera; the distortion is
 * taken off by iteration.
 * \return NaN where the distortion has no inverse near the pixel \ingroup core */
ACMAP_EXPORT Eigen::Vector3d
pixelRay(const CameraCalibration& camera, const Eigen::Vector2d& pixel);

/** \brief Where a camera sees a point, in px.
 * \param[in] point metres, in the frame of this camera, before it (z > 0)
 * \ingroup core */
ACMAP_EXPORT Eigen::Vector2d
projectPoint(const CameraCalibration& camera, const Eigen::Vector3d& point);

/** \brief The cameras that a rectified rig is made of: without distortion, on its
 * baselines. \ingroup core */
ACMAP_EXPORT RigCalibration
calibrationOf(const TrinocularRig& rig);

/** \brief Reads the cameras from a `rig.yaml`; see doc/core/rig_calibration.md.
 * \throws InputFileException naming file, line, key and value; also when the file has
 * only a rectified rig, or one of other cameras \ingroup core */
ACMAP_EXPORT RigCalibration
loadRigCalibration(const std::string& path);

/** \brief Writes a `rig.yaml` that holds both: the rectified rig and its cameras.
 * \throws BadArgumentException for a rig or cameras that cannot be
 * \throws OutputFileException when the file could not be written whole \ingroup core */
ACMAP_EXPORT void
saveRigCalibration(const std::string& path,
                   const TrinocularRig& rig,
                   const RigCalibration& calibration);

} // namespace pcl
