#pragma once

#include <cstdint>

namespace pcl::acmap {

/** \brief Disparities of a pair are looked at sixteen at once. */
constexpr int disparity_block = 16;

/** \brief What is taken for the cost of a disparity that none is searched at: filling up. */
constexpr std::int16_t filled_cost = 8000;

/** \brief The most that a real cost may be, so that sums of paths fit. */
constexpr std::int16_t largest_cost = 4000;

/** \brief Rows of numbers, several at one place: those of shot k begin at values + k *
 * plane. */
template <typename Value>
struct ShotRows {
  const Value* values = nullptr;
  std::int64_t plane = 0; ///< from one shot to the next
  int shots = 0;
};

/** \brief Costs of one row, or of their sums: disparity i of pixel x is at x * stride + i.
 */
struct CostRow {
  std::int16_t* values = nullptr;
  int width = 0;
  int stride = 0; ///< a multiple of disparity_block
};

/** \brief Sums of square windows, by their middle pixels. */
struct WindowRow {
  const float* mean;         ///< sum over the root of the number of values
  const float* inverse_norm; ///< 1 over the root of the sum of squares about the mean
};

/** \brief What a step along a path costs. */
struct PathPenalties {
  std::int16_t small = 0;       ///< P1, a change by 1
  const std::int16_t* beside;   ///< P2 from the pixel before in the row, for each pixel
  const std::int16_t* above[3]; ///< P2 from the row before: before, above, behind
};

/** \brief Costs along the paths that come from the row before, in the directions before,
 * above, behind: slots of stride + disparity_block, one for each pixel and one on either
 * side; behind a slot's costs stand paddings that never win. */
struct PathRows {
  std::int16_t* costs[3];
  std::int16_t* least[3];
};

/** \brief Best disparity index of each pixel, and best pixel of each place in the
 * neighbour's row. */
struct RowWinners {
  std::int16_t* index;        ///< by pixel
  std::int16_t* target_least; ///< by index + pixel, of the neighbour's row
  std::int16_t* target_pixel;
};

/** \brief Sums over shots, at sixteen quarter pixels round a disparity. */
struct SubPixelSums {
  static constexpr int quarters = 16;
  float products[quarters]; ///< of both views
  float squares[quarters];  ///< of the neighbour
  float values[quarters];   ///< of the neighbour
};

/** \brief The same over a window, at eight of them. */
struct WindowAtQuarters {
  static constexpr int places = 8;
  float products[places];
  float squares[places];
  float values[places];
};

/** \brief The loops that take most of the time of a pair, in variants for processors; all
 * give the same bytes. */
struct PairKernels {
  /** Sums over shots of products, for a row of pixels and their disparities.
   * \param[in] target at the first disparity of the first pixel
   * \param[out] costs scale (1 - sum), within 0 and largest_cost */
  void (*correlate)(const ShotRows<float>& reference,
                    const ShotRows<float>& target,
                    float scale,
                    const CostRow& costs);

  /** Adds (or takes off) the sums over shots of products of whole numbers.
   * \param[in,out] sums width * stride */
  void (*addProducts)(const ShotRows<std::int16_t>& reference,
                      const ShotRows<std::int16_t>& target,
                      int width,
                      int stride,
                      int sign,
                      std::int32_t* sums);

  /** Costs from the correlation over a square window.
   * \param[in] sums of products, of columns, from radius columns before the first pixel on
   * \param[in] window of the reference's row, and of the neighbour's at the first disparity
   * of the first pixel */
  void (*correlateWindows)(const std::int32_t* sums,
                           int radius,
                           const WindowRow& reference,
                           const WindowRow& target,
                           float scale,
                           const CostRow& costs);

  /** Bits that differ. \param[in] target as above */
  void (*countBits)(const ShotRows<std::uint64_t>& reference,
                    const ShotRows<std::uint64_t>& target,
                    std::int16_t cost_of_bit,
                    const CostRow& costs);

  /** Path costs of a row, from those of the row before; one of them runs in the row, from
   * its begin on, or from its end when reversed.
   * \param[in,out] sums overwritten, or added to when reversed */
  void (*follow)(const CostRow& costs,
                 const PathPenalties& penalties,
                 const PathRows& before,
                 const PathRows& after,
                 bool reversed,
                 std::int16_t* sums);

  /** \param[in] disparities those that are real; the rest of the stride fills up */
  void (*findWinners)(const CostRow& sums, int disparities, const RowWinners& winners);

  /** \param[in] pixel values of the reference's pixel
   * \param[in] target quarter pixels, eight before the disparity */
  void (*sumAtQuarters)(const ShotRows<float>& pixel,
                        const ShotRows<float>& target,
                        SubPixelSums& sums);

  /** \param[in] pixels of the window: the first of eight products of each, in its sums
   * \param[in] values whether those are wanted too */
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
