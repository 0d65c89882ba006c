#pragma once

#include "filled_runs.h"
#include "simd/entropy_bins.h"

#include <pcl/mapping/impl/map_entropy_kernel.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The floor of a position in bins; faster than std::floor if only SSE2 is
 * available. */
inline std::int64_t
binOf(double place)
{
  const auto bin = static_cast<std::int64_t>(place);
  return bin - (static_cast<double>(bin) > place ? 1 : 0);
}

/** \brief The bins that a map needs. Bin (i, j) begins at (i, j) times the edge length
 * for any map, so that entropies of different poses are comparable. */
struct BinRange {
  std::int64_t min_x = INT64_MAX, max_x = INT64_MIN;
  std::int64_t min_z = INT64_MAX, max_z = INT64_MIN;

  void
  add(std::int64_t x, std::int64_t z);

  void
  add(const BinRange& other);

  bool
  isEmpty() const
  {
    return max_x < min_x;
  }
};

/** \brief q(x, z) of Eq. 3, in one layer, or in one layer per wall direction and one
 * for points without a direction. Most bins are empty: only runs around the filled ones
 * are processed.
 *
 * For each evaluation: call \ref begin, fill \ref bins and mark their blocks (a mark
 * also represents the two following rows), then call \ref finish, which replaces the
 * filled bins by derivatives if requested. */
class EntropyGrid {
public:
  explicit EntropyGrid(const MapEntropySettings& settings);

  /** \brief Number of bins of all layers, computed before allocation. */
  static double
  binsOf(const BinRange& range, const MapEntropySettings& settings);

  /** \brief Clears the grid and sets its range.
   * \param[in] range of the bins that will be filled; the grid adds the margin that
   * smoothing needs */
  void
  begin(const BinRange& range);

  /** \brief The bins to be filled: the range, and one bin around it because of
   * rounding. */
  const BinArray&
  bins() const
  {
    return array_;
  }

  /** \brief Index of the first bin of the grid. */
  std::int64_t
  firstX() const
  {
    return first_x_;
  }

  std::int64_t
  firstZ() const
  {
    return first_z_;
  }

  /** \brief Smooths the bins and computes the entropies.
   * \param[in] weight sum of the filled values
   * \param[in] sensitivities if true, each filled bin is replaced by d total / d Q,
   * where Q is the share of the weight filled into it; constants, which cancel, are
   * omitted */
  MapEntropyTerms
  finish(double weight, bool sensitivities);

  void
  tell(MapEntropyReport& report) const;

private:
  /** \brief Bins with padding before the first and after the last one, because loops
   * access bins beyond the ends. */
  class Field {
  public:
    void
    reserve(std::int64_t bins, std::int64_t room);

    float*
    begin()
    {
      return values_.data() + room_;
    }

  private:
    std::vector<float> values_;
    std::int64_t room_ = 0;
  };

  class Strips;

  std::int64_t
  firstOf(const FilledRun& run) const
  {
    return std::int64_t{run.row} * depth_ + std::int64_t{run.begin} * BinArray::block;
  }

  /** \brief Smoothed projections of the filled bins: q_X and q_Z, not normalised. */
  void
  project();

  /** \brief Smooths and computes logarithms. \return sum of q log2 q */
  double
  takeLogarithms();

  /** \brief Computes d total / d filled value from the logarithms. */
  void
  takeSensitivities();

  /** \brief Contribution of the logarithms of a projection to the sensitivities. */
  std::vector<float>
  sensitivitiesOf(const std::vector<double>& logarithms) const;

  MapEntropySettings settings_;
  std::vector<double> kernel_; ///< Gaussian to 3 sigma; from the middle outwards
  std::vector<float> float_kernel_;
  double smoothed_weight_; ///< sum of the kernel in floats, squared; nearly 1
  std::int64_t radius_, layers_;
  std::int64_t aside_; ///< the radius in bins, rounded up to whole blocks
  std::int64_t first_x_ = 0, first_z_ = 0, width_ = 0, depth_ = 0;
  BinArray array_;
  BlockMarks marks_;
  Field bins_;                    ///< 0 outside of the runs of filled_
  Field logarithms_;              ///< valid in the runs of spread_
  std::vector<FilledRun> filled_; ///< filled bins
  std::vector<FilledRun> spread_; ///< filled bins and those within smoothing
  std::vector<double> on_x_, on_z_;
};

/** \brief Returns a power of two by which the weights of a map are multiplied, so that
 * floats can represent all their sums and the logarithms are small.
 * \param[in] weight of the whole map */
double
unitFor(double weight);

/** \brief Number of layers of a grid. */
int
layersOf(const MapEntropySettings& settings);

} // namespace pcl::acmap
