#pragma once

#include <pcl/core/rig_calibration.h>

namespace pcl::acmap {

// What cameras of a rig may have, in memory and in files.
constexpr std::size_t longest_camera_side = 32768; // px
constexpr double longest_camera_focal_length = 1e6;
constexpr double largest_camera_distortion = 1e6;
constexpr double longest_camera_baseline = 100.0; // metres

/** \brief By \ref RigCamera: what a camera is called in files and messages. */
constexpr std::array<const char*, 3> camera_keys = {
    "camera_reference", "camera_horizontal", "camera_vertical"};

/** \brief What is wrong with the place of a camera, empty when a rig can have it.
 * \param[in] is_reference whether all other places start from it */
std::string
faultOfPlace(const Eigen::Isometry3d& T_reference_camera, bool is_reference);

} // namespace pcl::acmap
