#pragma once

#include <cstdint>

namespace pcl::acmap {

/** \brief Number of disparities of a pair that are processed at once. */
constexpr int disparity_block = 16;

/** \brief Cost of the padding behind the search range. */
constexpr std::int16_t filled_cost = 8000;

/** \brief Maximum cost, so that sums along paths do not overflow. */
constexpr std::int16_t largest_cost = 4000;

/** \brief Rows of values of several shots: those of shot k begin at values + k * plane.
 */
template <typename Value>
struct ShotRows {
  const Value* values = nullptr;
  std::int64_t plane = 0; ///< offset from one shot to the next
  int shots = 0;
};

/** \brief Costs of one row, or sums of costs: disparity i of pixel x is at x * stride +
 * i. */
struct CostRow {
  std::int16_t* values = nullptr;
  int width = 0;
  int stride = 0; ///< a multiple of disparity_block
};

/** \brief Sums over square windows, indexed by their middle pixels. */
struct WindowRow {
  const float* mean;         ///< sum divided by the root of the number of values
  const float* inverse_norm; ///< 1 / root of the sum of squares about the mean
};

/** \brief Penalties of a step along a path. */
struct PathPenalties {
  std::int16_t small = 0;       ///< P1, for a change by 1
  const std::int16_t* beside;   ///< P2 from the previous pixel in the row, per pixel
  const std::int16_t* above[3]; ///< P2 from the previous row: before, above, behind
};

/** \brief Costs along the paths that come from the previous row, from the directions
 * before, above, behind. There are slots of stride + disparity_block, one for each
 * pixel and one on either side; the costs of a slot are followed by a padding that
 * never wins. */
struct PathRows {
  std::int16_t* costs[3];
  std::int16_t* minimum[3];
};

/** \brief Index of the best disparity of each pixel, and the best pixel for each
 * position in the neighbour's row. */
struct RowWinners {
  std::int16_t* index;          ///< per pixel
  std::int16_t* target_minimum; ///< per pixel of the neighbour's row (index + pixel)
  std::int16_t* target_pixel;
};

/** \brief Sums over the shots for each pixel of a row, of the levels' squares and of the
 * levels themselves; and sums of these over the pixel and two on either side. */
struct LevelSums {
  float* squares;
  float* values;
  float* squares_of_five;
  float* values_of_five;
};

/** \brief Sums over the shots for a row of a pair and its winners. Two pixels before and
 * behind the row are outside. */
struct MatchedRow {
  static constexpr int outside = 1 << 20;     ///< shift to a column that is not there
  static constexpr int products_of_pixel = 8; ///< at whole pixels
  static constexpr int before = 3;            ///< of these are before the winner

  // Places before a row where there are eight zeros.
  static constexpr int zeros = -16;        ///< of the products
  static constexpr int own_zeros = -8;     ///< of the sums of the reference
  static constexpr int target_zeros = -24; ///< of the sums of the neighbour

  const int* shifts;   ///< from a pixel to its winner's column
  const int* least;    ///< shift of the pixel and two on either side
  const int* greatest; ///< the same
  const float* products;
  const float* products_of_five; ///< sums over the pixel and two on either side
  LevelSums reference;           ///< per pixel
  LevelSums target;              ///< per quarter of the neighbour's pixels
};

/** \brief What the windows of a row have in common. */
struct WindowTerms {
  int width; ///< of the row, px
  int shots;
  float noise_floor; ///< added to the variances
  bool centred;      ///< as in \ref MatchingRecipe
};

/** \brief A window at the quarter pixels around the winner of its middle. */
struct WindowMatch {
  static constexpr int places = 8; ///< from -1 px on
  float correlation[places];       ///< ZNCC
  float variance;                  ///< of the reference
  float size;                      ///< number of values that are compared
};

/** \brief The loops that take most of the time of a pair, in variants for different
 * processors; all variants give the same bytes. */
struct PairKernels {
  /** Adds (or subtracts) the sums over shots of products of integers.
   * \param[in] sign 1 or -1
   * \param[in,out] sums width * stride values */
  void (*addProducts)(const ShotRows<std::int16_t>& reference,
                      const ShotRows<std::int16_t>& target,
                      int width,
                      int stride,
                      int sign,
                      std::int32_t* sums);

  /** Computes costs from the correlation over a square window.
   * \param[in] sums of products, over columns, starting radius columns before the first
   * pixel
   * \param[in] reference, target windows of the reference's row, and of the neighbour's
   * row starting at the first disparity of the first pixel */
  void (*correlateWindows)(const std::int32_t* sums,
                           int radius,
                           const WindowRow& reference,
                           const WindowRow& target,
                           float scale,
                           const CostRow& costs);

  /** Counts the bits that differ. \param[in] target as above */
  void (*countBits)(const ShotRows<std::uint64_t>& reference,
                    const ShotRows<std::uint64_t>& target,
                    std::int16_t cost_of_bit,
                    const CostRow& costs);

  /** Computes path costs of a row from those of the previous row. One path runs within
   * the row, from its begin, or from its end if reversed.
   * \param[in,out] sums are overwritten, or added to if reversed */
  void (*follow)(const CostRow& costs,
                 const PathPenalties& penalties,
                 const PathRows& before,
                 const PathRows& after,
                 bool reversed,
                 std::int16_t* sums);

  /** \param[in] disparities number of disparities without the padding of the stride */
  void (*findWinners)(const CostRow& sums, int disparities, const RowWinners& winners);

  /** Sums products at the whole pixels around each pixel's winner. \param[in] target
   * readable from before to products_of_pixel - before px beside the columns */
  void (*sumProducts)(const ShotRows<float>& reference,
                      const ShotRows<float>& target,
                      int width,
                      const int* shifts,
                      float* products);

  /** Sums squares and, if wanted, values, in whole blocks of eight pixels. */
  void (*sumLevels)(const ShotRows<float>& reference,
                    int width,
                    bool values,
                    const LevelSums& sums);

  /** The same at each quarter of the pixels. \param[in] target readable from 1 px before
   * the blocks to 2 px behind them */
  void (*sumQuarters)(const ShotRows<float>& target,
                      int width,
                      bool values,
                      const LevelSums& sums);

  /** Sums the value and two on either side, in whole blocks of eight values.
   * \param[in] step from one value to the next */
  void (*sumFive)(const float* values, int count, int step, float* sums);

  /** Correlates the windows of 5 x 5 pixels around each pixel whose winner is not
   * outside. A window contains only the pixels whose shifts differ by at most 1 from that
   * of its middle. \param[in] rows the rows of the windows */
  void (*correlateAround)(const MatchedRow* const* rows,
                          int count,
                          const MatchedRow& middle,
                          const WindowTerms& terms,
                          WindowMatch* matches);
};

extern const PairKernels pair_kernels_base;
extern const PairKernels pair_kernels_avx2;

/** \brief The variant for this processor. */
const PairKernels&
pairKernels();

} // namespace pcl::acmap
