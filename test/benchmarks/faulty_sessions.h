#pragma once

#include <pcl/pipeline/map_comparison.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Number of the observation of a session with the same stamp as each of a map. */
MappedTrajectory
mappedTrajectory(const CompactMap& map, const SessionTruth& truth);

/** \brief Simulates a session of clouds.
 * \param[in] scene name of a scene of share/scenes
 * \param[in] is_small images of 240 x 180 pixels, of which 20 000 are points; the scene stays beside the
 * folder, as a file with the ending .yaml
 * \param[in] observations number of the first ones; 0: all */
void
simulateSession(const std::string& folder,
                const std::string& scene,
                int seed,
                bool is_small,
                std::size_t observations = 0);

/** \brief What is wrong with a recording. */
struct RecordingFault {
  std::string name;
  double drift = 0;       ///< factor on 1 % and 1 mm of each step, and 0.1 degrees
  double gap = 0;         ///< share of the observations that are missing, in one piece
  bool has_glass = false; ///< half of the largest wall lets rays through
  double depth_scale = 1; ///< of the points
  double pose_scale = 1;  ///< of the poses
  double bias = 0;        ///< as drift, but all steps share one draw
};

/** \brief Writes the observations of a session with a fault into a folder. */
void
writeFaulty(const std::string& folder,
            const std::string& session,
            const RecordingFault& fault,
            int seed);

} // namespace pcl::acmap::bench
