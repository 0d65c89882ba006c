#pragma once

#include <pcl/core/export.h>
#include <pcl/pipeline/depth_sensor.h>
#include <pcl/pipeline/rgbd_cameras.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief What is stated of an RGB-D recording, in place of what its folder tells.
 * \code
 * pcl::RgbdStatement stated;
 * stated.intrinsics = "camera.yaml";
 * const pcl::RgbdSequence recorded = pcl::openRgbdSequence ("recording", pcl::settingsOf (stated));
 * const pcl::ObservationSequence sequence (recorded, pcl::camerasOf (stated, recorded));
 * \endcode
 * \ingroup pipeline */
struct RgbdStatement {
  bool no_poses = false;    ///< leave poses out, known or not
  std::string intrinsics;   ///< file of the depth camera; empty: the folder's
  std::string color_camera; ///< file of the camera of the colours; empty: the folder's
  bool is_registered = false; ///< colour and depth images show the same, pixel by pixel
  std::optional<double> fx, fy, cx, cy; ///< pixels
  std::optional<double> depth_scale;    ///< number in a depth image that is one metre
  double max_depth = 0.0;               ///< metres; 0 for no limit
  double max_stamp_gap = RgbdSequenceSettings().max_stamp_gap; ///< seconds
};

/** \brief The settings for opening the folder. \ingroup pipeline */
ACMAP_EXPORT RgbdSequenceSettings
settingsOf(const RgbdStatement& stated);

/** \brief The stated cameras, otherwise those of the folder; no colour camera if colours
 * have the pixels of the depth camera.
 * \param[in] sequence that was opened with these settings, not empty
 * \throws InputFileException when a file of a camera, or all depth images cannot be read
 * \ingroup pipeline */
ACMAP_EXPORT RgbdCameras
camerasOf(const RgbdStatement& stated,
          const RgbdSequence& sequence,
          DepthSensor sensor = DepthSensor::Automatic);

/** \brief Size of the first depth image of a recording that can be read.
 * \throws InputFileException if none can be read
 * \throws BadArgumentException without frames \ingroup pipeline */
ACMAP_EXPORT ImageSize
depthSizeOf(const RgbdSequence& sequence);

/** \brief What is assumed of a recording, and what its images and lists contradict: remarks,
 * each once with what states another. \ingroup pipeline */
ACMAP_EXPORT std::vector<std::string>
rgbdRemarks(const RgbdStatement& stated,
            const RgbdSequence& sequence,
            const RgbdCameras& cameras);

} // namespace pcl
