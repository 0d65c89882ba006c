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

/** \brief Sums over shots, at sixteen quarter pixels around a disparity. */
struct SubPixelSums {
  static constexpr int quarters = 16;
  float products[quarters]; ///< of both views
  float squares[quarters];  ///< of the neighbour
  float values[quarters];   ///< of the neighbour
};

/** \brief The same sums over a window, at eight quarter pixels. */
struct WindowAtQuarters {
  static constexpr int places = 8;
  float products[places];
  float squares[places];
  float values[places];
};

/** \brief The loops that take most of the time of a pair, in variants for different
 * processors; all variants give the same bytes. */
struct PairKernels {
  /** Computes the sums over shots of products, for a row of pixels and their
   * disparities.
   * \param[in] target starts at the first disparity of the first pixel
   * \param[out] costs scale (1 - sum), limited to 0 and largest_cost */
  void (*correlate)(const ShotRows<float>& reference,
                    const ShotRows<float>& target,
                    float scale,
                    const CostRow& costs);

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

  /** \param[in] pixel values of the pixel of the reference
   * \param[in] target quarter pixels, starting eight before the disparity */
  void (*sumAtQuarters)(const ShotRows<float>& pixel,
                        const ShotRows<float>& target,
                        SubPixelSums& sums);

  /** \param[in] pixels of the window: for each, the first of eight products in its sums
   * \param[in] values if true, the sums of the values are computed as well */
  void (*sumWindow)(const float* const* pixels,
                    int count,
                    bool values,
                    WindowAtQuarters& window);
};

extern const PairKernels pair_kernels_base;
extern const PairKernels pair_kernels_avx2;

/** \brief The variant for this processor. */
const PairKernels&
pairKernels();

} // namespace pcl::acmap
