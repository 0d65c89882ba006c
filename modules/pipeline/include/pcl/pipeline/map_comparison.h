#pragma once

#include <pcl/core/compact_map.h>
#include <pcl/core/export.h>
#include <pcl/pipeline/observation_sequence.h>
#include <pcl/pipeline/session_truth.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** \brief The trajectory of a map's camera, as estimated first and as rectified. */
struct MappedTrajectory {
  std::vector<std::size_t> observations; ///< indices in the session; some may be lost
  /** T_map_camera, one per observation above. */
  std::vector<Eigen::Isometry3d> before, after;
};

/** \brief A main plane of the truth and the corresponding plane of the map. */
struct PlaneDeviation {
  std::string name;
  std::optional<std::size_t> finder; ///< index in the map; empty: not found
  double angle = 0;                  ///< degrees, for unoriented normals
  double offset = 0;  ///< metres, at the centroid of the overlap of the two
  double overlap = 0; ///< square metres
  double cover =
      0; ///< square metres, of the true plane, by all planes that correspond to it
};

/** \brief Deviation of a map from the truth in a common frame. NaN where nothing was
 * found. */
struct MapDeviation {
  std::vector<PlaneDeviation> planes; ///< the main ones
  std::size_t found = 0;
  double mean_angle = 0, largest_angle = 0;   ///< degrees, over the planes found
  double mean_offset = 0, largest_offset = 0; ///< metres
  double ate_before = 0, ate_after = 0;       ///< metres, on the floor
};

/** \brief Comparison of a map with the truth. The map's frame is that of its first
 * observation, so an error of the first few poses rotates and translates the whole
 * map. */
struct MapFigures {
  /** After the best alignment of the trajectory on the floor. The ATE before and after
   * use an alignment each; planes use that of the trajectory after. */
  MapDeviation aligned;
  /** With the first posed observation at its true pose. */
  MapDeviation from_first;
  double compactness = std::numeric_limits<double>::quiet_NaN(); ///< set by the caller
};

/** \brief Compares a map with the session from which it was computed. A true plane is
 * found when a plane of the map deviates by at most 3 degrees and 10 cm from it and
 * more than half of its area is on it. A plane of the map corresponds to the closest
 * possible true plane; of several planes for one true plane, that with the largest
 * overlap counts, and their union is its cover.
 * \throws InputFileException when the session has no such observation
 * \throws BadArgumentException when the trajectory has no observations, or their
 * numbers differ */
ACMAP_EXPORT MapFigures
compareWithTruth(const CompactMap& map,
                 const MappedTrajectory& trajectory,
                 const SessionTruth& truth);

/** \brief The same for observations with poses, such as those of \ref acmap::Chain; their names
 * tell which of the session they are. A map may have left some of them out: those whose time it
 * does not have.
 * \param[in] before one pose per observation; empty: those of the map
 * \throws InputFileException also when an observation has no true pose */
ACMAP_EXPORT MapFigures
compareWithTruth(const CompactMap& map,
                 const ObservationSequence& observations,
                 const Trajectory& before,
                 const SessionTruth& truth);

namespace acmap {

/** \brief The figures in a report, a JSON object: those of `aligned`, "compactness", "planes" and
 * "from_first"; null where nothing was found. */
ACMAP_EXPORT std::string
truthDetailsText(const MapFigures& figures);

/** \brief The figures as lines of a summary, name and value; without the compactness, which
 * every map has. */
ACMAP_EXPORT std::vector<std::pair<std::string, std::string>>
truthSummary(const MapFigures& figures);

} // namespace acmap
} // namespace pcl
