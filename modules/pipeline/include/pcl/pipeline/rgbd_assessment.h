#pragma once

#include <pcl/core/export.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What the images of an RGB-D recording say of its assumptions. \ingroup pipeline */
struct RgbdAssessment {
  std::size_t frames = 0;  ///< that were looked at
  double median_depth = 0; ///< metres, with the scale that was assumed
  /** \brief All depths are multiples of this number. */
  int common_divisor = 0;
  /** \brief Numbers in a metre if the steps of the depths are those of a Kinect; nothing if
   * the depths have no such steps. */
  std::optional<double> scale_of_steps;
  /** \brief Shift of the colours at which their edges agree best with those of the depths,
   * pixels; nothing if none agrees better than others. */
  std::optional<Eigen::Vector2d> color_shift;
  std::vector<std::string> remarks; ///< what contradicts the assumptions
};

/** \brief Compares the scale of the depths with their steps and with the size of rooms, and
 * the edges of the colours with those of the depths, in up to five frames of a recording.
 * Frames that cannot be read are left out. O(pixels)
 * \param[in] cameras with the scale to check \ingroup pipeline */
ACMAP_EXPORT RgbdAssessment
assessRgbd(const RgbdSequence& sequence, const RgbdCameras& cameras);

namespace acmap {

/** \brief "5000 numbers", of a depth image in a metre. */
ACMAP_EXPORT std::string
depthScaleText(double scale);

} // namespace acmap

} // namespace pcl
