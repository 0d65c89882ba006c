#pragma once

#include <pcl/pipeline/compact_mapping.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief Settings of the whole table. */
struct PaperWaySettings {
  std::size_t observations = 6; ///< the first ones of each input
  /** \brief Maximum where raw points are meshed: above it every second, fourth ... is
   * taken. */
  std::size_t points = 60000;
};

/** \brief The paper's way, ours, or ours with one departure from the paper taken
 * back. */
struct PaperWay {
  const char* name;
  const char* stereo; ///< option of pcl_active_stereo
  bool meshes_raw;    ///< raw points are meshed
  void (*change)(CompactMapping& mapping);
};

const std::vector<PaperWay>&
paperWays();

/** \brief Result of a way for one input. */
struct PaperWayRun {
  std::string failure; ///< empty if there is a map
  CompactMap map;
  Trajectory odometry; ///< before the rectification
  std::size_t every = 1;
  double compactness = 0; ///< 16 bytes per point divided by the size of map.glb
  double seconds = 0;     ///< wall time, without stereo
};

/** \param[in] is_rigid the motion model, where the way is not the paper's */
PaperWayRun
runPaperWay(const PaperWay& way,
            const ObservationSequence& observations,
            bool is_rigid,
            const PaperWaySettings& settings);

} // namespace pcl::acmap::bench
