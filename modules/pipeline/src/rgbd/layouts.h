#pragma once

#include <pcl/pipeline/rgbd_sequence.h>

#include <string>

namespace pcl::acmap {

/** \brief Opens the layout of TUM: rgb.txt, depth.txt, groundtruth.txt. */
RgbdSequence
openTumSequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openTumSequence? */
bool
isTumSequence(const std::string& folder);

/** \brief Opens the layout of Open3D: folders depth and color, image or rgb,
 * camera_intrinsic.json, trajectory.log. */
RgbdSequence
openOpen3dSequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openOpen3dSequence? */
bool
isOpen3dSequence(const std::string& folder);

/** \brief Opens the layout of 7-Scenes: frame-000000.color.jpg, .depth.png,
 * .pose.txt. */
RgbdSequence
openSevenScenesSequence(const std::string& folder,
                        const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openSevenScenesSequence? */
bool
isSevenScenesSequence(const std::string& folder);

} // namespace pcl::acmap
