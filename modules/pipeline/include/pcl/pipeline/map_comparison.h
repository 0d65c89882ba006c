#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/pipeline/session_truth.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief The way of a map's camera, as it was estimated first and as the map was made. */
struct MappedTrajectory {
  std::vector<std::size_t> observations; ///< of the session; some may be lost
  /** T_map_camera, one an observation above. */
  std::vector<Eigen::Isometry3d> before, after;
};

/** \brief A main plane of the truth and the plane of the map that finds it. */
struct PlaneDeviation {
  std::string name;
  std::optional<std::size_t> finder; ///< index in the map; none: not found
  double angle = 0;                  ///< degrees, whatever the signs of the normals
  double offset = 0;  ///< metres, where the two overlap, in the middle of that area
  double overlap = 0; ///< square metres
};

/** \brief What a map is off in one frame that it shares with the truth. NaN where nothing
 * was found. */
struct MapDeviation {
  std::vector<PlaneDeviation> planes; ///< the main ones
  std::size_t found = 0;
  double mean_angle = 0, largest_angle = 0;   ///< degrees, of those found
  double mean_offset = 0, largest_offset = 0; ///< metres
  double ate_before = 0, ate_after = 0;       ///< metres, on the floor
};

/** \brief A map beside the truth. The map's frame is that of its first observation, so an
 * error of the first few poses turns and shifts all of it. */
struct MapFigures {
  /** After the turn and the shift on the floor that fit the way best: of its own each for
   * the ATE before and after, for planes that of the way after. */
  MapDeviation aligned;
  /** With the first observation that has a pose where it truly was. */
  MapDeviation from_first;
  double compactness = std::numeric_limits<double>::quiet_NaN(); ///< the caller's
};

/** \brief Compares a map with the session it was made of. A true plane is found when a
 * plane of the map deviates by at most 3 degrees and 10 cm from it and lies on it by more
 * than half. A plane of the map stands for the nearest of those that it could be, and of
 * several that stand for one the largest overlap counts.
 * \throws InputFileException when the session has no such observation
 * \throws BadArgumentException when the way has no observations, or their numbers differ */
ACMAP_EXPORT MapFigures
compareWithTruth(const CompactMap& map,
                 const MappedTrajectory& trajectory,
                 const SessionTruth& truth);

} // namespace pcl
