#pragma once

#include <pcl/core/export.h>
#include <pcl/core/planar_pose.h>
#include <pcl/core/point_view.h>
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

/** \brief A grid of more bins (all layers) is refused: two of them are held, 256 MB. */
inline constexpr double maximum_entropy_bins = 33554432;

/** \brief The points of an observation within half a bin of each other; within a whole
 * one where they fill it evenly. */
struct EntropyCell {
  double x = 0, z = 0;  ///< metres, mean in the sensor's frame
  double weight = 0;    ///< number of points, or the sum of their weights
  double direction = 0; ///< rad, atan2 (n_z, n_x) towards the sensor; NaN: none
};

/** \brief An observation as cells, in an order that does not depend on the points'. */
struct EntropyCells {
  std::vector<EntropyCell> cells;
  std::size_t points = 0, invalid_points = 0, distant_points = 0, directed_points = 0;
};

/** \brief An observation as it came. */
struct PosedPoints {
  PointView points;  ///< metres, sensor's frame
  PointView normals; ///< unit, of the same points; empty: none
  PlanarPose pose;
  const float* weights = nullptr; ///< one a point; nullptr: 1 each
};

/** \throws BadArgumentException unless x and z are within [-1e9, 1e9] m and theta within
 * [-1e3, 1e3] rad */
ACMAP_EXPORT void
requirePlanarPose(const PlanarPose& pose);

/** \throws BadArgumentException unless there are none or one for each point, and naming
 * the first that is negative or not finite */
ACMAP_EXPORT void
requirePointWeights(const std::vector<float>& weights, std::size_t points);

/** \throws BadArgumentException unless \a number is less than \a observations */
ACMAP_EXPORT void
requireObservation(std::size_t number, std::size_t observations);

/** \brief Sums the points of an observation up in cells of half a bin, and of 11.25
 * degrees where directions count. Cells of one bin and direction of which none holds half
 * of it become one.
 * \param[in] weights one a point, in their order; rounded to 2^-15 of the largest.
 * nullptr: 1 each
 * \throws BadArgumentException naming the first weight that is negative or not finite */
ACMAP_EXPORT EntropyCells
aggregateCells(const PointView& points,
               const PointView& normals,
               const MapEntropySettings& settings,
               const float* weights = nullptr);

/** \brief The fast entropy, continuously differentiable in every pose, of observations
 * whose poses change. Keeps its memory from one evaluation to the next. */
class ACMAP_EXPORT MapEntropyEvaluator {
public:
  /** \throws BadArgumentException when the smoothing is wider than 100 bins, or a cell
   * is not finite, has a negative weight or lies farther than 2e9 m */
  MapEntropyEvaluator(const std::vector<EntropyCells>& observations,
                      const MapEntropySettings& settings);

  ~MapEntropyEvaluator();
  MapEntropyEvaluator(const MapEntropyEvaluator& other);
  MapEntropyEvaluator(MapEntropyEvaluator&& other) noexcept;
  MapEntropyEvaluator&
  operator=(MapEntropyEvaluator other) noexcept;

  /** \param[in] poses one for each observation, see \ref PosedPoints
   * \param[out] report counts and remarks are added
   * \param[out] gradient d total / d (x, z, theta) of each pose, bits per metre and
   * radian; nullptr: not wanted
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

/** \brief The entropy as the paper counts it, each point in the bin it lies in.
 * \param[out] report counts and remarks are added
 * \throws BadArgumentException as \ref requirePlanarPose, \ref aggregateCells
 * \throws CancelledException when the progress was told to stop */
ACMAP_EXPORT MapEntropyTerms
exactMapEntropy(const std::vector<PosedPoints>& observations,
                const MapEntropySettings& settings,
                const Progress& progress,
                MapEntropyReport& report);

} // namespace pcl::acmap
