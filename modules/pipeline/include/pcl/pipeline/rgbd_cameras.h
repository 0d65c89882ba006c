#pragma once

#include "pinhole.h"

#include <pcl/core/yaml_node.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl::acmap {

/** \brief A colour camera next to the depth camera. */
struct ColorCamera {
  Pinhole pinhole;
  Eigen::Isometry3d T_depth_color; ///< its pose in the depth camera's frame, metres
};

/** \brief Default colour camera for a Kinect as used for 7-Scenes, whose calibration
 * was never published: the usual focal length, and the pose that was measured for
 * another Kinect (see doc/tools/pcl_rgbd_import.md for its accuracy). */
ColorCamera
kinectColorCamera();

/** \brief Reads a colour camera from YAML: focal_length, or focal_length_x and
 * focal_length_y, center_x, center_y (pixels); position (metres) and rotation (rows),
 * its pose in the depth camera's frame.
 * \throws InputFileException naming file, line and fault */
ColorCamera
loadColorCamera(const std::string& path);

/** \brief Reads a colour camera from a YAML node. */
ColorCamera
readColorCamera(const YamlNode& camera);

} // namespace pcl::acmap
