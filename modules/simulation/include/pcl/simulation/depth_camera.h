#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trinocular_rig.h>

namespace pcl {

/** \brief A camera beside a projector of speckles, as the first Kinect is: it finds a
 * window of the speckles it sees in a stored picture of them, which gives a disparity,
 * and rounds that disparity.
 *
 * The camera is the rig of the scene; baseline_horizontal of the rig is the place of the
 * projector, and disparity_sigma the noise of a disparity on a surface that faces the
 * camera. Where the numbers come from is told on the page of this header.
 * \ingroup simulation */
struct DepthCamera {
  int window = 9;                ///< px, odd; edge of the windows that are correlated
  double disparity_step = 0.125; ///< px; disparities are multiples of it
  double depth_step = 0.001;     ///< metres; depths are written as multiples of it
  int blind_columns = 8;         ///< px, at the right rim of the image
  double nearest = 0.5;          ///< metres; no smaller depth is measured
  double fading = 6.0;           ///< metres; beyond it a growing share is missing
  double farthest = 8.0;         ///< metres; no larger depth is measured
};

/** \brief The depth camera of a Kinect: 640 x 480 pixels, focal length 575 px, the
 * projector 7.5 cm to the right, disparities with a noise of 0.08 px. \ingroup simulation
 */
ACMAP_EXPORT TrinocularRig
kinectRig();

/** \brief Refuses a depth camera that cannot be.
 * \throws BadArgumentException naming value, legal range and unit \ingroup simulation */
ACMAP_EXPORT void
requireSoundDepthCamera(const DepthCamera& camera, const TrinocularRig& rig);

} // namespace pcl
