#pragma once

#include "bag/bag_topics.h"

#include <pcl/pipeline/bag_settings.h>

#include <string>

namespace pcl::acmap {

/** \brief From a body with x ahead and z up to a camera with z ahead and y down, T_camera_body.
 */
Eigen::Isometry3d
cameraOfBody();

/** \brief Are the axes of a frame those of a camera, by its name? */
bool
isOpticalFrame(const std::string& frame);

/** \brief Connects the frame of a sensor with one that moves, where the tree of a bag does not:
 * by what the settings state, otherwise by the names of the frames, with a remark.
 * \param[in] is_camera has the frame the axes of a camera?
 * \return Is the motion of the frame known then?
 * \throws InputFileException if its mounting on what moves is neither known nor stated
 * \throws BadArgumentException if it is stated, and known */
bool
connectSensor(BagTopics& topics,
              const std::string& frame,
              bool is_camera,
              const BagSettings& settings);

} // namespace pcl::acmap
