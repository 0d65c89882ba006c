#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>
#include <pcl/core/progress.h>
#include <pcl/core/trajectory.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace pcl {

class ObservationSequence;

namespace acmap {

class OutputFolder;

/** \brief An observation that is to be written. */
struct ObservationToWrite {
  PCLPointCloud2::ConstPtr cloud; ///< organized, camera frame, metres
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  double stamp = 0; ///< seconds
  std::string name =
      {}; ///< of the file; empty: \ref observationName of those before it
};

/** \brief How observations are written. */
struct ObservationWriting {
  ProgressCallback progress;
  std::string step = "writing"; ///< name of the step for the progress
  /** \brief Called after each observation, for files beside it. */
  std::function<void(const ObservationToWrite&)> written = {};
};

/** \brief Makes observations and writes them as PCDs with their poses as VIEWPOINT, one
 * after another.
 * \param[in] count number of observations that can be made
 * \param[in] make gets 0 to count - 1; without a result, the observation is left out
 * \return times and poses of those that were written
 * \throws OutputFileException as \ref saveObservation
 * \throws CancelledException when the progress callback requests it */
ACMAP_EXPORT Trajectory
writeObservations(
    const OutputFolder& folder,
    std::size_t count,
    const std::function<std::optional<ObservationToWrite>(std::size_t)>& make,
    const ObservationWriting& writing);

/** \brief Writes all observations of a sequence under their names, and trajectory.txt if
 * their poses are known, else times.txt. Each is read once, and is not kept in memory.
 * \throws as above, and InputFileException for an observation that cannot be read */
ACMAP_EXPORT void
writeObservations(const OutputFolder& folder,
                  ObservationSequence sequence,
                  const ObservationWriting& writing = {});

} // namespace acmap
} // namespace pcl
