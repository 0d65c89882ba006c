#pragma once

#include "color_camera.h"

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief A colour and a depth image of one moment, not read yet. */
struct RgbdFrame {
  std::string color; ///< path
  std::string depth; ///< path
  double stamp = 0;  ///< seconds, or the frame's number where there is no time

  /** \brief Path of a 4 x 4 matrix T_world_camera; empty without one. */
  std::string pose_file;

  std::optional<Eigen::Isometry3d> T_world_camera; ///< where it is known already
};

/** \brief What is wanted of a sequence. */
struct SequenceSettings {
  bool has_poses = true;        ///< poses are needed
  double most_stamp_gap = 0.02; ///< seconds, between what belongs together
  bool has_camera = false;      ///< the user names the camera
};

/** \brief What an RGB-D folder holds. */
struct RgbdSequence {
  std::string layout; ///< its name
  std::vector<RgbdFrame> frames;
  Pinhole camera;
  double depth_scale = 1000.0; ///< numbers of a depth image in a metre
  bool is_registered = false;  ///< colours are known to be those of the depth's pixels
  std::optional<ColorCamera> color_camera; ///< where one beside is known
  std::size_t unmatched = 0;               ///< depth images without a colour image
  std::size_t unposed = 0; ///< frames left out, as nothing tells their pose
  std::vector<std::string> remarks;
};

/** \brief Finds out the layout of a folder and lists its frames, without the images.
 * \throws InputFileException when it is no RGB-D folder, or a list in it is malformed
 * \throws NothingFound when no frame is left */
RgbdSequence
openSequence(const std::string& folder, const SequenceSettings& settings);

/** \brief The layout of TUM: rgb.txt, depth.txt, groundtruth.txt. */
RgbdSequence
openTumSequence(const std::string& folder, const SequenceSettings& settings);

/** \brief Whether a folder has the layout of \ref openTumSequence. */
bool
isTumSequence(const std::string& folder);

/** \brief The layout of 7-Scenes: frame-000000.color.jpg, .depth.png, .pose.txt. */
RgbdSequence
openSevenScenesSequence(const std::string& folder, const SequenceSettings& settings);

/** \brief Whether a folder has the layout of \ref openSevenScenesSequence. */
bool
isSevenScenesSequence(const std::string& folder);

/** \brief Pose of a frame that has one, in its file or already known.
 * \throws InputFileException when the file is missing or no rigid motion */
Eigen::Isometry3d
poseOf(const RgbdFrame& frame);

} // namespace pcl::acmap
