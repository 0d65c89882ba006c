#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_rig.h>

namespace pcl {

/** \brief A depth camera with a speckle projector beside it, such as the first Kinect.
 * It correlates a window of the observed speckles with a stored reference image of
 * them, which gives a disparity, and rounds the disparity.
 *
 * The camera is the rig of the scene; the rig's baseline_horizontal is the position of
 * the projector, and its disparity_sigma is the noise of a disparity on a surface that
 * faces the camera. The documentation page of this header describes the origin of the
 * default values.
 * \ingroup simulation */
struct DepthCamera {
  int window = 9;                ///< px, odd; side length of the correlation windows
  double disparity_step = 0.125; ///< px; disparities are multiples of it
  double depth_step = 0.001;     ///< metres; depths are rounded to multiples of it
  int blind_columns = 8;         ///< px, at the right border of the image
  double nearest = 0.5;          ///< metres; smaller depths are not measured
  double fading = 6.0;   ///< metres; beyond it an increasing fraction is missing
  double farthest = 8.0; ///< metres; larger depths are not measured
};

/** \brief The rig of a Kinect depth camera: 640 x 480 pixels, focal length 575 px, the
 * projector 7.5 cm to the right, disparity noise 0.08 px. \ingroup simulation */
ACMAP_EXPORT TrinocularRig
kinectRig();

/** \brief Checks the parameters of a depth camera.
 * \throws BadArgumentException naming value, valid range and unit
 * \ingroup simulation */
ACMAP_EXPORT void
requireSoundDepthCamera(const DepthCamera& camera, const TrinocularRig& rig);

} // namespace pcl
