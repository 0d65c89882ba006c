#pragma once

#include "pair_kernels.h"

#include <cstdint>

namespace pcl::acmap {

// Costs over time are so clear that a byte is sufficient for them: twice as many
// disparities are processed at once.

/** \brief Number of disparities that are processed at once. */
constexpr int byte_block = 32;

/** \brief Unit of the costs in bytes: as small as eight times the usual P2, 400, in a byte
 * permits. No correlation costs 2000. */
constexpr int byte_cost_unit = 13;

/** \brief Maximum cost, so that sums along paths do not overflow. */
constexpr std::uint8_t largest_byte_cost = 200;

/** \brief Cost of the padding behind the search range. */
constexpr std::uint8_t filled_byte_cost = 210;

/** \brief As \ref CostRow; stride is a multiple of byte_block. */
struct ByteRow {
  std::uint8_t* values = nullptr;
  int width = 0;
  int stride = 0;
};

/** \brief As \ref PathRows, with slots of stride + byte_block. */
struct BytePathRows {
  std::uint8_t* costs[3];
  std::uint8_t* minimum[3];
};

/** \brief P1 and P2. With them, a cost along a path fits into a byte. */
struct BytePenalties {
  std::uint8_t small = 0;
  std::uint8_t large = 0; ///< at most 31: eight times this fits into a byte
};

/** \brief Cost along a path that is never the least, even with P1. */
constexpr std::uint8_t never_byte_cost = 242;

/** \brief Loops over costs in bytes, in variants as \ref PairKernels. */
struct ByteKernels {
  /** Normalizes the levels of pixels over time.
   * \param[in] levels readable for whole blocks of eight pixels
   * \param[in] floor is added to the sum of squares
   * \param[out] codes of two shots each, of plane pixels: the even one in the low half */
  void (*encode)(const ShotRows<std::int16_t>& levels,
                 int width,
                 float floor,
                 std::int64_t plane,
                 std::int32_t* codes);

  /** Computes costs from the correlation of codes.
   * \param[in] target starts at the first disparity of the first pixel */
  void (*correlate)(const ShotRows<std::int32_t>& reference,
                    const ShotRows<std::int32_t>& target,
                    const ByteRow& costs);

  /** As PairKernels::follow. \param[in,out] excess by which the sums along four paths are
   * above the costs themselves: written, or added to if reversed */
  void (*follow)(const ByteRow& costs,
                 const BytePenalties& penalties,
                 const BytePathRows& before,
                 const BytePathRows& after,
                 bool reversed,
                 std::uint8_t* excess);

  /** As PairKernels::findWinners, from the excess along eight paths. */
  void (*findWinners)(const ByteRow& costs,
                      const std::uint8_t* excess,
                      int disparities,
                      const RowWinners& winners);
};

extern const ByteKernels byte_kernels_base;
extern const ByteKernels byte_kernels_avx2;

/** \brief The variant for this processor. */
const ByteKernels&
byteKernels();

} // namespace pcl::acmap
