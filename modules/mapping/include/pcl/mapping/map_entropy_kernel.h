#pragma once

#include <pcl/core/export.h>
#include <pcl/core/point_view.h>
#include <pcl/core/progress.h>
#include <pcl/mapping/map_entropy_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref mapEntropy; see MapEntropy. */
struct MapEntropySettings {
  double bin_size = 0.1;          ///< metres
  double smoothing = 0.1;         ///< metres, sigma_XZ; at most 100 bins
  double projection_weight = 0.5; ///< mu
  bool direction_aware = false;
};

/** \brief A grid of more bins (all layers) is refused: two of them are held, 512 MB. */
inline constexpr double maximum_entropy_bins = 33554432;

/** \brief The points of an observation within half a bin of each other. */
struct EntropyCell {
  double x = 0, z = 0;  ///< metres, mean in the sensor's frame
  double weight = 0;    ///< number of points
  double direction = 0; ///< rad, atan2 (n_z, n_x) towards the sensor; NaN: none
};

/** \brief An observation as cells, in an order that does not depend on the points'. */
struct EntropyCells {
  std::vector<EntropyCell> cells;
  std::size_t points = 0, invalid_points = 0, distant_points = 0, directed_points = 0;
};

/** \brief An observation as it came.
 *
 * Poses are (x, z, theta): metres, metres, radians about y, from the sensor's frame
 * into the map's: X = c x + s z + p_x, Z = -s x + c z + p_z. */
struct PosedPoints {
  PointView points;  ///< metres, sensor's frame
  PointView normals; ///< unit, of the same points; empty: none
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();
};

/** \brief Sums the points of an observation up in cells of half a bin, and of 11.25
 * degrees where directions count. */
ACMAP_EXPORT EntropyCells
aggregateCells(const PointView& points,
               const PointView& normals,
               const MapEntropySettings& settings);

/** \brief The fast entropy, continuously differentiable in every pose.
 * \param[in] poses one for each observation, see \ref PosedPoints
 * \param[out] report counts and remarks are added
 * \param[out] gradient d total / d (x, z, theta) of each pose, bits per metre and
 * radian; nullptr: not wanted
 * \throws BadArgumentException when poses and observations differ in number, or the
 * smoothing is wider than 100 bins */
ACMAP_EXPORT MapEntropyTerms
mapEntropy(const std::vector<EntropyCells>& observations,
           const std::vector<Eigen::Vector3d>& poses,
           const MapEntropySettings& settings,
           MapEntropyReport& report,
           std::vector<Eigen::Vector3d>* gradient = nullptr);

/** \brief The entropy as the paper counts it, each point in the bin it lies in.
 * \param[out] report counts and remarks are added
 * \throws CancelledException when the progress was told to stop */
ACMAP_EXPORT MapEntropyTerms
exactMapEntropy(const std::vector<PosedPoints>& observations,
                const MapEntropySettings& settings,
                const Progress& progress,
                MapEntropyReport& report);

} // namespace pcl::acmap
