#pragma once

#include "pinhole.h"

#include <pcl/core/yaml_node.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl::acmap {

/** \brief A camera that sees the colours from beside the depth camera. */
struct ColorCamera {
  Pinhole pinhole;
  Eigen::Isometry3d T_depth_color; ///< its pose in the depth camera's frame, metres
};

/** \brief That of a Kinect as 7-Scenes was recorded with, whose own was never published:
 * its usual focal length, and the place that was measured of another Kinect
 * (doc/tools/pcl_rgbd_import.md says how well it fits). */
ColorCamera
kinectColorCamera();

/** \brief Reads a colour camera from YAML: focal_length, or focal_length_x and
 * focal_length_y, center_x, center_y (pixels); position (metres) and rotation (rows), its
 * pose in the depth camera's frame.
 * \throws InputFileException naming file, line and fault */
ColorCamera
loadColorCamera(const std::string& path);

/** \brief The reader behind it. */
ColorCamera
readColorCamera(const YamlNode& camera);

} // namespace pcl::acmap
