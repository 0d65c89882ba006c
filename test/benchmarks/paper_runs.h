#pragma once

#include "chain_runs.h"

#include <pcl/core/compact_map.h>
#include <pcl/core/trajectory.h>
#include <pcl/pipeline/compact_mapping.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/session_truth.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Maps by ways between the paper's and ours, and what they are worth.

namespace pcl::acmap::bench {

/** \brief The paper's way, ours, or ours with one departure from the paper taken
 * back. */
struct PaperWay {
  std::string name;
  const char* stereo = nullptr; ///< option of pcl_active_stereo
  bool meshes_raw = false;      ///< raw points are meshed
  std::function<void(CompactMapping& mapping)> change;
};

constexpr const char *spacetime = "--method=spacetime",
                     *median_of_shots = "--method=median",
                     *statistical = "--method=statistical", *unlit = "--unlit";

/** \brief Every stage as in the paper. */
void
setPaperWay(CompactMapping& mapping);

/** \brief The egomotion alone as in the paper; planar, whatever the motion is. */
void
setPaperEgomotion(CompactMapping& mapping);

/** \brief The rectification alone as in the paper. */
void
setPaperRectification(CompactMapping& mapping);

/** \brief Result of a way for one input. */
struct PaperWayRun {
  std::string failure; ///< empty if there is a map
  CompactMap map;
  Trajectory odometry; ///< before the rectification
  std::size_t every = 1;
  double compactness = 0; ///< 16 bytes per point divided by the size of map.glb
  double seconds = 0;     ///< wall time, without stereo
};

/** \brief Maps observations.
 * \param[in] is_rigid the motion model, where the way is not the paper's
 * \param[in] max_raw_points where raw points are meshed: above it every second, fourth
 * ... is taken
 * \param[in] has_poses the poses of the observations are the odometry */
PaperWayRun
runPaperWay(const PaperWay& way,
            const ObservationSequence& observations,
            bool is_rigid,
            std::size_t max_raw_points,
            bool has_poses = false);

/** \brief Figures of a map that are not those of its run. */
struct PaperWayScores {
  std::size_t found = 0, planes = 0; ///< true planes that were found, of how many
  std::string missing;               ///< names of the true planes that were not
  std::size_t spurious = 0;          ///< planes of the map that are none of the truth
  double angle = 0;                  ///< degrees, mean
  double offset = 0;                 ///< metres, mean
  double ate = 0;                    ///< metres, aligned
  double cover = 0;                  ///< of the truth, square metres
};

/** \brief Compares with the truth of a session. */
PaperWayScores
scoresOf(const PaperWayRun& run, const SessionTruth& truth);

/** \brief Compares with the map of the given poses, which is made our way. */
PaperWayScores
scoresOf(const PaperWayRun& run,
         const CompactMap& reference,
         const std::vector<Eigen::Isometry3d>& given);

} // namespace pcl::acmap::bench
