#pragma once

#include <pcl/core/pinhole.h>
#include <pcl/core/rig_calibration.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What a calibration says of the images of a camera. \ingroup core */
struct CalibratedView {
  /** \brief Its pose is given in a frame that all cameras of the calibration share. */
  CameraCalibration camera;
  bool has_pose = false;
  int width = 0; ///< px; 0 where the file does not state it
  int height = 0;
};

/** \brief A camera of a calibration: its images as it gives them, and rectified. At
 * least one of both is known. \ingroup core */
struct CalibratedCamera {
  std::string name; ///< in the file, such as cam0
  std::optional<CalibratedView> built;
  std::optional<CalibratedView> rectified;
};

/** \brief A calibration by any program, in acmap's conventions: x right, y down, z
 * forward, metres, pixels counted from the centre of the first one. \ingroup core */
struct Calibration {
  std::string kind;       ///< of the file, such as "Kalibr's camchain"
  std::string convention; ///< how its numbers are understood, one sentence
  std::vector<CalibratedCamera> cameras;
  std::optional<double> depth_scale; ///< number of a depth image that is one metre
  std::optional<TrinocularRig> rig;  ///< of a rig.yaml, which may have three cameras
  bool has_built_rig = false; ///< a rig.yaml with the cameras before rectification
};

/** \brief Reads a calibration of one of the kinds in doc/core/calibration_file.md; the
 * contents determine which, not the name.
 * \throws InputFileException naming file and fault: an unknown kind, missing keys, a
 * camera model other than a pinhole with Brown-Conrady distortion \ingroup core */
ACMAP_EXPORT Calibration
loadCalibration(const std::string& path);

/** \brief What is known of the images of a rig, apart from their calibration.
 * \ingroup core */
struct RigImages {
  int width = 0; ///< px; 0: as the calibration says
  int height = 0;
  std::optional<bool> are_raw; ///< as the cameras gave them, or rectified
  bool of_camera = false; ///< live: raw where the calibration has the cameras as built
  bool are_grey = false;  ///< KITTI has a pair of grey and one of colour cameras

  bool has_horizontal = true; ///< else a horizontal neighbour of a rig.yaml is not used
  bool has_vertical = true;   ///< likewise

  /** \brief Position of the neighbour along x (y of a vertical one), metres, in place of
   * what the calibration says. */
  std::optional<double> baseline;

  /** \brief Names of reference and neighbour in the calibration; empty: the first two. */
  std::vector<std::string> cameras;
};

/** \brief A rig as its calibration states it. \ingroup core */
struct CalibratedRig {
  /** \brief Of rectified images; with \ref cameras only its size, and which cameras there
   * are, before rectification. */
  TrinocularRig rig;

  /** \brief Images have to be rectified by these cameras; none: they are rectified. */
  std::optional<RigCalibration> cameras;

  std::string told; ///< kind, convention and baseline, in one line
  bool leaves_built_out =
      false; ///< a rig.yaml has cameras as built, which are not used
};

/** \brief Reads the rig of a pair of cameras from a calibration, or from the two files of
 * its cameras, the reference first. A calibration for images of another size is scaled if
 * the shapes agree.
 * \throws InputFileException naming file, fault and the option that settles it: also
 * for a baseline that is missing or longer than 2 m, images of another shape, and a
 * calibration of which the images may be rectified or not \ingroup core */
ACMAP_EXPORT CalibratedRig
loadRig(const std::vector<std::string>& paths, const RigImages& images);

/** \brief A camera without a neighbour, as its calibration states it. \ingroup core */
struct CalibratedPinhole {
  Pinhole pinhole;
  int width = 0; ///< px of its images; 0: not stated
  int height = 0;
  std::optional<double> depth_scale; ///< number of a depth image that is one metre
  std::string told;                  ///< kind of the file, and what was left out
};

/** \brief Reads the camera of rectified or undistorted images from a calibration; of
 * several cameras the first, of KITTI's the left one with colour. A distortion is left
 * out, which is told.
 * \throws InputFileException as \ref loadCalibration \ingroup core */
ACMAP_EXPORT CalibratedPinhole
loadCameraPinhole(const std::string& path);

/** \brief The same camera for images of another size; as it is if its own is not known.
 * \throws InputFileException naming the path if the shapes do not agree \ingroup core */
ACMAP_EXPORT Pinhole
fittedPinhole(const CalibratedPinhole& camera,
              int width,
              int height,
              const std::string& path);

namespace acmap {

/** \brief Implementation of \ref loadCalibration.
 * \param[in] name file name in messages */
ACMAP_EXPORT Calibration
readCalibration(const std::string& name, const std::string& text);

/** \brief Implementation of \ref loadRig for calibrations that were read, without the
 * cameras of a `rig.yaml`. */
ACMAP_EXPORT CalibratedRig
rigOf(const std::vector<std::string>& names,
      const std::vector<Calibration>& calibrations,
      const RigImages& images);

} // namespace acmap
} // namespace pcl
