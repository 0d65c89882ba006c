#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/core/yaml_node.h>

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

} // namespace pcl::acmap
