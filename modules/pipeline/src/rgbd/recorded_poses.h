#pragma once

#include "rgbd/image_folder.h"
#include "rgbd/text_rows.h"

#include <pcl/core/impl/yaml_node.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Poses T_world_camera of a text file. */
struct RecordedPoses {
  std::vector<double> numbers; ///< times or numbers of frames; empty if there are none
  /** \brief Metres; nothing where the tracking was lost, which is written as -inf or nan. */
  std::vector<std::optional<Eigen::Isometry3d>> poses;
};

/** \brief Reads poses, one in a row: 8 numbers (`stamp tx ty tz qx qy qz qw`, TUM), 12 (3 x 4
 * matrix, KITTI), 16 (4 x 4 matrix), or 13 or 17 with a number before; or in the five rows of
 * Redwood's logs, or the four rows of a matrix.
 * \throws InputFileException naming file, line and fault */
RecordedPoses
loadRecordedPoses(const std::string& path);

/** \brief The same of the rows of a file.
 * \param[in] path for messages, and .log for Redwood's form */
RecordedPoses
posesOfRows(const std::vector<TextRow>& rows, const std::string& path);

/** \brief The poses of transforms.json, as nerfstudio and Polycam write it, by the numbers in
 * the names of the images.
 * \throws InputFileException naming file, line and fault */
RecordedPoses
posesOfFrames(const YamlNode& transforms);

/** \brief Reads the pose of one frame, a 4 x 4 matrix.
 * \return nothing if the tracking was lost
 * \throws InputFileException as above */
std::optional<Eigen::Isometry3d>
loadRecordedPose(const std::string& path);

/** \brief Is the pose in a file one that was lost: all of its numbers are infinite or nan?
 * False for a file that is missing or malformed. */
bool
isLostPose(const std::string& path);

/** \brief Reads a matrix without checking that it is rigid.
 * \throws InputFileException as \ref loadSquareMatrix */
Eigen::Matrix4d
loadMatrix4(const std::string& path);

/** \brief Gives frames their poses: by their times if both have them; in their order if there
 * are as many as depth images or as frames; else by the numbers in the names.
 * Frames without a pose are removed and counted.
 * \param[in] path of the poses, for messages
 * \param[in] gap seconds, maximum for times
 * \throws InputFileException if there are no poses for these frames */
void
takePoses(const RecordedPoses& recorded,
          const std::string& path,
          double gap,
          NamedFrames& named,
          RgbdSequence& sequence);

/** \brief Finds the poses of a folder, a file or one file a frame, and takes them. Without
 * any, the sequence has none, and a remark tells it. */
void
takePosesOfFolder(const std::filesystem::path& folder,
                  double gap,
                  NamedFrames& named,
                  RgbdSequence& sequence);

/** \brief Notes that a recording has no poses.
 * \param[in] wanted what was looked for */
void
goWithoutPoses(const std::string& wanted, RgbdSequence& sequence);

/** \brief Moves the frames into the sequence. */
void
takeFrames(NamedFrames named, RgbdSequence& sequence);

} // namespace pcl::acmap
