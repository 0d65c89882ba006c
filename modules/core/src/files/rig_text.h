#pragma once

#include <pcl/core/impl/yaml_node.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_rig.h>

#include <string>

namespace pcl::acmap {

/** \brief Returns the text of a `rig.yaml` with a valid rig. */
std::string
rigText(const TrinocularRig& rig);

/** \brief Implementation of \ref loadRigCalibration.
 * \param[in] name file name in messages
 * \param[in] map the document
 * \throws InputFileException naming file and fault */
RigCalibration
readRigCalibration(const std::string& name, const YamlNode& map);

/** \brief Returns the text that \ref saveRigCalibration writes.
 * \throws BadArgumentException as \ref saveRigCalibration */
std::string
rigCalibrationText(const TrinocularRig& rig, const RigCalibration& calibration);

// Limits of the cameras of a rig, in memory and in files.
constexpr std::size_t longest_camera_side = 32768; // px
constexpr double longest_camera_focal_length = 1e6;
constexpr double largest_camera_distortion = 1e6;
constexpr double longest_camera_baseline = 100.0; // metres

/** \brief Names of the cameras in files and messages, indexed by \ref RigCamera. */
constexpr std::array<const char*, 3> camera_keys = {
    "camera_reference", "camera_horizontal", "camera_vertical"};

/** \brief Describes what is wrong with the pose of a camera; empty if it is valid.
 * \param[in] is_reference true for the camera in whose frame all poses are given */
std::string
faultOfPlace(const Eigen::Isometry3d& T_reference_camera, bool is_reference);

} // namespace pcl::acmap
