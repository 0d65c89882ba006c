#pragma once

#include <pcl/core/export.h>
#include <pcl/core/trajectory.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/mapping/map_verdict_types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief Result of a step that finds or corrects the poses of a sequence, from which a
 * later run can go on. \ingroup pipeline */
struct EstimatedPoses {
  std::vector<std::size_t> places; ///< indices of the observations that have a pose
  Trajectory trajectory;           ///< their poses, metres
  /** \brief Noise of the motions, if they were estimated. */
  std::optional<OdometryNoise> noise;
  /** \brief The up axis of their frame, if the map was levelled. */
  std::optional<Eigen::Vector3d> up;
  /** \brief The verdict on these poses, if the step asked for one. */
  std::optional<VerdictOutcome> verdict = std::nullopt;
};

/** \brief Writes poses into a folder: trajectory.txt, and the rest as poses.yaml.
 * \param[in] folder that exists
 * \throws BadArgumentException if the trajectory has another number of poses
 * \throws OutputFileException if a file could not be written completely
 * \ingroup pipeline */
ACMAP_EXPORT void
saveEstimatedPoses(const std::string& folder, const EstimatedPoses& poses);

/** \brief Reads the output of \ref saveEstimatedPoses.
 * \return nothing if there are no poses
 * \throws InputFileException if a file is malformed
 * \ingroup pipeline */
ACMAP_EXPORT std::optional<EstimatedPoses>
loadEstimatedPoses(const std::string& folder);

} // namespace pcl
