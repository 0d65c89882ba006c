#pragma once

#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/pose_convention_check.h>
#include <pcl/pipeline/rgbd_observation.h>
#include <pcl/pipeline/rgbd_sequence.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

namespace acmap {
class OutputFolder;
} // namespace acmap

/** \brief How the frames of an RGB-D recording are written. \ingroup pipeline */
struct RgbdImportSettings {
  std::size_t every = 1;    ///< take only each n-th frame; 0 is taken as 1
  bool skip_broken = false; ///< leave out frames with a missing or damaged file
  unsigned threads = 0;     ///< 0 for all
  ProgressCallback progress = {};
};

/** \brief Result of \ref importRgbd. \ingroup pipeline */
struct RgbdImport {
  Trajectory trajectory; ///< T_first_camera of each observation; identity without poses
  RgbdImageSizes sizes;  ///< of the images of all frames
  ImageSize size;        ///< of the observations
  std::uint64_t points = 0;        ///< of all observations
  double finite_share = 0;         ///< fraction of the pixels that have a point
  double median_depth = 0;         ///< metres, over all points
  std::size_t empty = 0;           ///< observations without a point
  std::size_t refined = 0;         ///< observations whose depth was quantised
  std::vector<std::string> broken; ///< reasons why frames were left out
  /** \brief What is odd: principal points far from the middle, poses that exceed buildings,
   * observations without a point. */
  std::vector<std::string> remarks;
};

/** \brief Writes the frames of an RGB-D recording as a sequence of observations: organized
 * PCDs of x y z rgb sigma with their poses as VIEWPOINT, relative to the first camera.
 *
 * The steps of quantised depth are removed (\ref loadRgbdObservation). O(pixels).
 * \code
 * const pcl::RgbdSequence recorded = pcl::openRgbdSequence ("recording");
 * pcl::acmap::OutputFolder folder ("observations");
 * const pcl::RgbdImport written = pcl::importRgbd (recorded, recorded.cameras (), folder);
 * pcl::saveTrajectory (folder.path ("trajectory.txt"), written.trajectory);
 * folder.commit ();
 * \endcode
 * \throws InputFileException when an image or a pose is missing or malformed, or an image
 * differs in size from those before, unless broken frames are skipped
 * \throws OutputFileException when a file could not be written completely
 * \throws CancelledException when the progress callback requests it \ingroup pipeline */
ACMAP_EXPORT RgbdImport
importRgbd(const RgbdSequence& sequence,
           const RgbdCameras& cameras,
           const acmap::OutputFolder& folder,
           const RgbdImportSettings& settings = {});

/** \brief Checks the recorded poses of all frames against their views, and replaces them by
 * what they mean; frames whose pose cannot be read keep the path of its file.
 * \param[in] check with what is stated of the poses
 * \return nothing without poses
 * \throws InputFileException as \ref PoseConventionCheck::compute \ingroup pipeline */
ACMAP_EXPORT std::optional<PoseConventionReport>
readRecordedPoses(PoseConventionCheck check,
                  const RgbdCameras& cameras,
                  RgbdSequence& sequence);

} // namespace pcl
