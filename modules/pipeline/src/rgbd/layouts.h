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

/** \brief Opens the layout of ORB-SLAM: associations.txt, which joins the images of TUM's
 * folders. */
RgbdSequence
openAssociatedSequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openAssociatedSequence? */
bool
isAssociatedSequence(const std::string& folder);

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

/** \brief Opens what ScanNet's reader exports: folders color, depth, pose and intrinsic. */
RgbdSequence
openScannetSequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openScannetSequence? */
bool
isScannetSequence(const std::string& folder);

/** \brief Opens Replica as NICE-SLAM has it: results/frame000000.jpg and depth000000.png,
 * traj.txt, cam_params.json. */
RgbdSequence
openReplicaSequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openReplicaSequence? */
bool
isReplicaSequence(const std::string& folder);

/** \brief Opens a recording of StrayScanner: depth, confidence, odometry.csv,
 * camera_matrix.csv, and the images of its video in rgb. */
RgbdSequence
openStraySequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openStraySequence? */
bool
isStraySequence(const std::string& folder);

/** \brief Opens a recording that Record3D exported: rgb, depth, metadata.json. */
RgbdSequence
openRecord3dSequence(const std::string& folder, const RgbdSequenceSettings& settings);

/** \brief Does a folder have the layout of \ref openRecord3dSequence? */
bool
isRecord3dSequence(const std::string& folder);

} // namespace pcl::acmap
