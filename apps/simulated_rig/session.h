#pragma once

#include "stage_log.h"

#include <pcl/acquisition/random_line_pattern.h>
#include <pcl/core/output_folder.h>
#include <pcl/core/rig_calibration.h>
#include <pcl/simulation/simulated_rig_grabber.h>
#include <pcl/simulation/truth_file.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap {

constexpr const char* rig_name = "rig.yaml";
constexpr const char* truth_name = "truth.json";

/** \brief A scene and the cameras that film it. */
struct FilmedScene {
  /** \brief The scene. Its rig is that of the rectified frames, its views are poses of
   * the rectified reference camera: the ground truth refers to both. */
  SimulatedScene scene;

  /** \brief Unrectified cameras; if not set, those of the rig. */
  std::optional<RigCalibration> cameras;
  std::string cameras_path; ///< path of their file

  /** \brief Transforms from the frame of the unrectified reference camera to the
   * rectified one. */
  Eigen::Isometry3d T_rectified_reference = Eigen::Isometry3d::Identity();
};

/** \brief Replaces the cameras of the scene's rig by unrectified ones.
 * \param[in] path of a `rig.yaml` with cameras
 * \return warnings about them
 * \throws InputFileException when no cameras can be read, or none can be rectified
 * \throws MemoryLimitException when their images do not fit */
std::vector<std::string>
setBuiltCameras(const std::string& path, FilmedScene& filmed);

/** \brief Settings for filming a scene. */
struct SessionSettings {
  std::size_t observations = 0; ///< at least 1
  std::uint32_t patterns = 10;
  RandomLinePattern lines; ///< of a pattern; its size and seed are not used
  SimulatedLight light;
  std::uint64_t seed = 1;
};

/** \brief Statistics of the session, for summary and report. */
struct SessionCounts {
  TruthPoints measurable; ///< pixels that active stereo can measure
  std::size_t frames = 0;
  std::size_t seen = 0; ///< pixels of the reference view that see a surface
  std::size_t lit = 0;  ///< of these, the ones that the projector lights
};

/** \brief Would a file of that name be a part of a session? */
bool
isSessionName(const std::string& name);

/** \brief Writes the images of the cameras under each pattern, and the ground truth of
 * each observation: disparities, visibility, poses, planes. All files are in the
 * folder's hidden part until it is committed.
 * \throws InputFileException when the cameras cannot be simulated
 * \throws MemoryLimitException when the patterns do not fit
 * \throws OutputFileException when a file could not be written completely
 * \throws CancelledException when the callback requests it */
SessionCounts
writeSession(const OutputFolder& folder,
             const FilmedScene& filmed,
             const SessionSettings& settings,
             const RunControls& controls);

} // namespace pcl::acmap
