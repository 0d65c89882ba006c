#pragma once

#include "filled_runs.h"
#include "simd/entropy_bins.h"

#include <pcl/mapping/map_entropy_kernel.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The floor of a place in bins, without the call that it takes where SSE2 is
 * all. */
inline std::int64_t
binOf(double place)
{
  const auto bin = static_cast<std::int64_t>(place);
  return bin - (static_cast<double>(bin) > place ? 1 : 0);
}

/** \brief The bins that a map needs: bin (i, j) begins at (i, j) times the bin's edge,
 * whatever the map, so that entropies of different poses compare. */
struct BinRange {
  std::int64_t least_x = INT64_MAX, most_x = INT64_MIN;
  std::int64_t least_z = INT64_MAX, most_z = INT64_MIN;

  void
  add(std::int64_t x, std::int64_t z);

  void
  add(const BinRange& other);

  bool
  isEmpty() const
  {
    return most_x < least_x;
  }
};

/** \brief q(x, z) of Eq. 3, in one layer or in one for each direction of walls and one
 * for points without. Most bins are empty: only runs around what was filled in are
 * worked on.
 *
 * Each time: \ref begin; fill \ref bins, marking the blocks, where a mark also stands for
 * the two rows that follow; \ref finish, which leaves derivatives in the filled bins where
 * these are wanted. */
class EntropyGrid {
public:
  explicit EntropyGrid(const MapEntropySettings& settings);

  /** \brief Bins of all layers, before anything is allocated. */
  static double
  binsOf(const BinRange& range, const MapEntropySettings& settings);

  /** \brief Empties the grid and lets it cover a range.
   * \param[in] range of the bins that will be filled; the grid adds what smoothing
   * needs */
  void
  begin(const BinRange& range);

  /** \brief To be filled: the range and, against rounding, one bin around it. */
  const BinArray&
  bins() const
  {
    return array_;
  }

  /** \brief Index of the grid's first bin. */
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

  /** \brief Smooths and takes the entropies.
   * \param[in] weight sum of what was filled in
   * \param[in] sensitivities whether each bin that was filled shall become d total / d Q,
   * where Q is the share of the weight filled into it; constants, which cancel, are left
   * out */
  MapEntropyTerms
  finish(double weight, bool sensitivities);

  void
  tell(MapEntropyReport& report) const;

private:
  /** \brief Bins with room before the first and behind the last, as loops reach over the
   * ends. */
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

  /** \brief Sums of what was filled in, smoothed: q_X and q_Z, not normalised. */
  void
  project();

  /** \brief Smooths and takes logarithms. \return sum of q log2 q */
  double
  takeLogarithms();

  /** \brief Logarithms become d total / d of what was filled in. */
  void
  takeSensitivities();

  /** \brief What logarithms of projections add to these. */
  std::vector<float>
  sensitivitiesOf(const std::vector<double>& logarithms) const;

  MapEntropySettings settings_;
  std::vector<double> kernel_; ///< Gaussian, cut at 3 sigma; from its middle outwards
  std::vector<float> float_kernel_;
  double smoothed_weight_; ///< what floats make of a weight of 1, nearly that
  std::int64_t radius_, layers_;
  std::int64_t aside_; ///< the radius in whole blocks, as bins
  std::int64_t first_x_ = 0, first_z_ = 0, width_ = 0, depth_ = 0;
  BinArray array_;
  BlockMarks marks_;
  Field bins_;                    ///< 0 where no run of filled_ says otherwise
  Field logarithms_;              ///< those in spread_ are of use
  std::vector<FilledRun> filled_; ///< what was filled
  std::vector<FilledRun> spread_; ///< and what smoothing reaches
  std::vector<double> on_x_, on_z_;
};

/** \brief A power of two by which the weights of a map are multiplied, so that floats
 * can hold all their sums and logarithms are small.
 * \param[in] weight of the whole map */
double
unitFor(double weight);

/** \brief Layers of a grid. */
int
layersOf(const MapEntropySettings& settings);

} // namespace pcl::acmap
