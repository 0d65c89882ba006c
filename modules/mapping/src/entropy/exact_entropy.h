#pragma once

#include "entropy_grid.h"
#include "map_extent.h"
#include "planar_motion.h"
#include "wall_direction.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::acmap {

/** \brief The points of an observation that lie in one bin of the map. */
struct FilledBin {
  std::int64_t x, z;
  int layer;
  double weight; ///< an integer, so that sums do not depend on their order
};

/** \brief The bins of an observation under one pose. */
struct FilledBins {
  PlanarPose pose;
  BinRange range;
  std::vector<FilledBin> bins; ///< a bin may occur several times
};

/** \brief The points of an observation that are counted: finite, not distant, and with
 * a weight. */
class CountedPoints {
public:
  /** \param[in] largest weight of all observations
   * \param[in,out] report receives the numbers of points */
  CountedPoints(const PosedPoints& observation,
                float largest,
                const MapEntropySettings& settings,
                MapEntropyReport& report);

  /** \brief Counts each point in its bin. */
  FilledBins
  fill(const PlanarPose& pose) const;

  /** \brief In the sensor's frame, metres. */
  const MapExtent&
  extent() const
  {
    return extent_;
  }

private:
  /** \brief Calls visit (point, x, z) for each point and its bin. */
  template <typename Visit>
  void
  forEachPoint(const PlanarMotion& motion, const Visit& visit) const;

  /** \brief Counts points of equal weight in one layer; most of the time is spent here.
   * \param[in,out] sums of the bins of the window */
  void
  countAlike(const PlanarMotion& motion,
             const BinRange& window,
             std::vector<double>& sums) const;

  /** \brief A range that contains the bins of all points. */
  BinRange
  rangeUnder(const PlanarMotion& motion) const;

  double
  weightOf(std::size_t point) const
  {
    return weights_.empty() ? equal_weight_ : static_cast<double>(weights_[point]);
  }

  int
  layerOf(std::size_t point, const PlanarMotion& motion) const;

  double bin_size_;
  std::vector<float> x_, z_;              ///< metres, sensor's frame
  std::vector<std::uint16_t> weights_;    ///< empty: all are equal
  std::vector<WallDirection> directions_; ///< empty: they are not used
  double equal_weight_;
  Eigen::Array2d minimum_, maximum_; ///< corners of the points, metres
  MapExtent extent_;
};

/** \brief The entropy of the paper, each point counted in its bin, for observations
 * whose poses change: only observations that moved are counted again. */
class ExactEntropyEvaluator {
public:
  /** \param[in] observations their poses are not used
   * \throws BadArgumentException when the smoothing is wider than 100 bins, or a weight
   * is negative or not finite
   * \throws CancelledException when the progress callback requested to stop */
  ExactEntropyEvaluator(const std::vector<PosedPoints>& observations,
                        const MapEntropySettings& settings,
                        const Progress& progress);

  /** \brief Computes the entropy under poses, one per observation.
   * \param[out] report counts and remarks are added
   * \throws BadArgumentException as \ref requirePlanarPose */
  MapEntropyTerms
  evaluate(const std::vector<PlanarPose>& poses, MapEntropyReport& report);

  /** \brief Remembers the poses of the last evaluation, from which the next ones
   * differ little. */
  void
  keep();

  /** \brief Number of observations that the last evaluation counted. */
  std::size_t
  counted() const
  {
    return counted_;
  }

private:
  struct Observation {
    CountedPoints points;
    std::optional<FilledBins> kept, tried;

    /** \brief Returns true if the points have to be counted. */
    bool
    move(const PlanarPose& pose);

    /** \brief The bins under the last pose. */
    const FilledBins&
    current() const
    {
      return tried ? *tried : *kept;
    }
  };

  /** \brief Fills the grid with the sum of all observations.
   * \param[in] unit value of the weight 1 */
  void
  fillGrid(double unit);

  MapEntropySettings settings_;
  MapEntropyReport counts_;
  std::vector<Observation> observations_;
  std::atomic<std::size_t> counted_{0};
  EntropyGrid grid_;
  std::vector<double> sums_; ///< of the weights in each bin, 0 between evaluations
};

} // namespace pcl::acmap
