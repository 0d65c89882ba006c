#pragma once

#include <pcl/core/export.h>
#include <pcl/core/impl/point_view.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/progress.h>
#include <pcl/mapping/map_entropy_types.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace pcl::acmap {

/** \brief Settings of \ref mapEntropy; see MapEntropy. */
struct MapEntropySettings {
  double bin_size = 0.1;          ///< metres
  double smoothing = 0.1;         ///< metres, sigma_XZ; at most 100 bins
  double projection_weight = 0.5; ///< mu
  bool direction_aware = false;
};

/** \brief Grids with more bins (all layers) are refused: two of them are stored, 256
 * MB. */
inline constexpr double maximum_entropy_bins = 33554432;

/** \brief Sum of the points of an observation in half a bin, or in a whole bin if they
 * fill it evenly. */
struct EntropyCell {
  double x = 0, z = 0;  ///< metres, mean in the sensor's frame
  double weight = 0;    ///< number of points, or the sum of their weights
  double direction = 0; ///< rad, atan2 (n_z, n_x) towards the sensor; NaN: none
};

/** \brief An observation as cells; their order does not depend on that of the
 * points. */
struct EntropyCells {
  std::vector<EntropyCell> cells;
  std::size_t points = 0, invalid_points = 0, distant_points = 0, directed_points = 0;
};

/** \brief An observation as it was given. */
struct PosedPoints {
  PointView points;  ///< metres, sensor's frame
  PointView normals; ///< unit, of the same points; empty: none
  PlanarPose pose;
  const float* weights = nullptr; ///< one per point; nullptr: 1 each
};

/** \throws BadArgumentException unless x and z are within [-1e9, 1e9] m and theta
 * within [-1e3, 1e3] rad */
ACMAP_EXPORT void
requirePlanarPose(const PlanarPose& pose);

/** \throws BadArgumentException unless there are none or one per point; names the first
 * one that is negative or not finite */
ACMAP_EXPORT void
requirePointWeights(const std::vector<float>& weights, std::size_t points);

/** \throws BadArgumentException unless \a number is less than \a observations */
ACMAP_EXPORT void
requireObservation(std::size_t number, std::size_t observations);

/** \brief Aggregates the points of an observation in cells of half a bin, and of 11.25
 * degrees if directions are used. The cells of one bin and direction are merged if none
 * of them contains half of its weight.
 * \param[in] weights one per point, in their order; rounded to 2^-15 of the maximum.
 * nullptr: 1 each
 * \throws BadArgumentException naming the first weight that is negative or not
 * finite */
ACMAP_EXPORT EntropyCells
aggregateCells(const PointView& points,
               const PointView& normals,
               const MapEntropySettings& settings,
               const float* weights = nullptr);

/** \brief The fast entropy, continuously differentiable with respect to each pose, for
 * observations whose poses change. The memory is reused between evaluations. */
class ACMAP_EXPORT MapEntropyEvaluator {
public:
  /** \throws BadArgumentException when the smoothing is wider than 100 bins, or a cell
   * is not finite, has a negative weight or is farther away than 2e9 m */
  MapEntropyEvaluator(const std::vector<EntropyCells>& observations,
                      const MapEntropySettings& settings);

  ~MapEntropyEvaluator();
  MapEntropyEvaluator(const MapEntropyEvaluator& other);
  MapEntropyEvaluator(MapEntropyEvaluator&& other) noexcept;
  MapEntropyEvaluator&
  operator=(MapEntropyEvaluator other) noexcept;

  /** \param[in] poses one per observation, see \ref PosedPoints
   * \param[out] report counts and remarks are added
   * \param[out] gradient d total / d (x, z, theta) of each pose, bits per metre and
   * radian; nullptr: not computed
   * \throws BadArgumentException when poses and observations differ in number, or as
   * \ref requirePlanarPose */
  MapEntropyTerms
  evaluate(const std::vector<PlanarPose>& poses,
           MapEntropyReport& report,
           std::vector<Eigen::Vector3d>* gradient = nullptr);

private:
  struct State;
  std::unique_ptr<State> state_;
};

/** \brief One evaluation; see \ref MapEntropyEvaluator. */
ACMAP_EXPORT MapEntropyTerms
mapEntropy(const std::vector<EntropyCells>& observations,
           const std::vector<PlanarPose>& poses,
           const MapEntropySettings& settings,
           MapEntropyReport& report,
           std::vector<Eigen::Vector3d>* gradient = nullptr);

/** \brief Computes the entropy as in the paper, each point in its bin.
 * \param[out] report counts and remarks are added
 * \throws BadArgumentException as \ref requirePlanarPose, \ref aggregateCells
 * \throws CancelledException when the progress callback requested to stop */
ACMAP_EXPORT MapEntropyTerms
exactMapEntropy(const std::vector<PosedPoints>& observations,
                const MapEntropySettings& settings,
                const Progress& progress,
                MapEntropyReport& report);

} // namespace pcl::acmap
