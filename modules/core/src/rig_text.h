#pragma once

#include <pcl/core/rig_calibration.h>
#include <pcl/core/trinocular_rig.h>
#include <pcl/core/yaml_node.h>

#include <string>

namespace pcl::acmap {

/** \brief The text of a `rig.yaml` with a sound rig. */
std::string
rigText(const TrinocularRig& rig);

/** \brief The reader behind \ref loadRigCalibration.
 * \param[in] name stands for the file in messages
 * \throws InputFileException naming file and fault */
RigCalibration
readRigCalibration(const std::string& name, const YamlNode& map);

/** \brief What \ref saveRigCalibration writes.
 * \throws BadArgumentException likewise */
std::string
rigCalibrationText(const TrinocularRig& rig, const RigCalibration& calibration);

} // namespace pcl::acmap
