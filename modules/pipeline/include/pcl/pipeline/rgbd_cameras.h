#pragma once

#include <pcl/core/export.h>
#include <pcl/core/pinhole.h>
#include <pcl/pipeline/depth_sensor.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <string>

namespace pcl {

/** \brief Reads a pinhole camera as \ref loadCameraPinhole, whatever its images' size.
 * \throws InputFileException when it is missing or has no pinhole camera
 * \ingroup pipeline */
ACMAP_EXPORT Pinhole
loadPinhole(const std::string& path);

/** \brief Size of an image in pixels. \ingroup pipeline */
struct ImageSize {
  std::int32_t width = 0;
  std::int32_t height = 0;
};

/** \brief A colour camera next to the depth camera. \ingroup pipeline */
struct ColorCamera {
  Pinhole pinhole;
  Eigen::Isometry3d T_depth_color; ///< its pose in the depth camera's frame, metres
  /** \brief Take the colours to the pixels of the depth camera, whose images are smaller,
   * instead of the points to those of this camera. */
  bool is_resampled = false;
};

/** \brief Default colour camera for a Kinect as used for 7-Scenes, whose calibration
 * was never published: the usual focal length, and the pose that was measured for
 * another Kinect (see doc/tools/pcl_rgbd_import.md for its accuracy).
 * \ingroup pipeline */
ACMAP_EXPORT ColorCamera
kinectColorCamera();

/** \brief Reads a colour camera from YAML: focal_length, or focal_length_x and
 * focal_length_y, center_x, center_y (pixels); position (metres) and rotation (rows),
 * its pose in the depth camera's frame.
 * \throws InputFileException naming file, line and fault \ingroup pipeline */
ACMAP_EXPORT ColorCamera
loadColorCamera(const std::string& path);

/** \brief Conversion of the numbers of a depth image to metres. \ingroup pipeline */
struct DepthMeaning {
  double scale = 1000.0;  ///< number that is one metre
  double max_depth = 0.0; ///< metres; points beyond are left out; 0 for no limit

  /** \brief Converts a number to metres; 0 if nothing was measured. */
  double
  metres(std::uint16_t number) const
  {
    constexpr std::uint16_t saturated = 65535;
    const double z = number == saturated ? 0.0 : number / scale;
    return max_depth > 0.0 && z > max_depth ? 0.0 : z;
  }
};

/** \brief The cameras of all frames of an RGB-D sequence. \ingroup pipeline */
struct RgbdCameras {
  Pinhole depth;
  /** \brief None: colours have the pixels of the depth camera. */
  std::optional<ColorCamera> color;
  DepthMeaning meaning;
  DepthSensor sensor = DepthSensor::Automatic;
};

namespace acmap {

class YamlNode;

/** \brief Reads a colour camera from a YAML node. */
ACMAP_EXPORT ColorCamera
readColorCamera(const YamlNode& camera);

} // namespace acmap

} // namespace pcl
