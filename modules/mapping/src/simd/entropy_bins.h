#pragma once

#include <cstdint>

namespace pcl::acmap {

/** \brief Bins of a grid, by layer, then x, then z. */
struct BinArray {
  float* bins = nullptr;
  std::int64_t row = 0;   ///< bins from one x to the next, a multiple of block
  std::int64_t layer = 0; ///< bins from one layer to the next

  /** Number of bins that are marked together. */
  static constexpr std::int64_t block = 4;

  std::uint8_t* marks = nullptr; ///< one per block; 1: it contains filled bins
};

/** \brief Cells as arrays. Their number is a multiple of four; cells without weight are
 * padding. */
struct CellArrays {
  const float* x = nullptr; ///< bins, from the reference
  const float* z = nullptr;
  const float* weight = nullptr;
  const float* direction = nullptr; ///< layers of direction, in the sensor's frame
  std::int64_t size = 0;
};

/** \brief Transformation of cells to a grid: cosine x + sine z + x0 bins from its
 * beginning. */
struct CellMotion {
  double cosine = 1, sine = 0;
  double x0 = 0, z0 = 0; ///< position of the reference, bins
  double turn = 0;       ///< layers of direction, added to those of the cells
};

/** \brief Forces on cells: derivatives by bins and layers of direction, summed over the
 * cells. */
struct CellForces {
  double x = 0, z = 0; ///< per bin
  double turn = 0;     ///< per radian, about the reference; by positions only
  double layers = 0;   ///< per layer of direction
};

/** \brief A symmetric kernel; radius + 1 weights from its middle outwards. */
struct SmoothingKernel {
  const float* weights;
  std::int64_t radius;
};

/** \brief Values from which the smoothed ones are subtracted: level + levels[j] at bin
 * j. */
struct SmoothingLevels {
  float level;
  const float* levels;
};

/** \brief The loops that take most of the time, in variants for different processors;
 * all variants give bitwise the same results.
 *
 * A cell is distributed over 3 x 3 bins by quadratic B-splines, in the directed loops
 * also over three of eight layers of direction. */
struct EntropyBins {
  void (*fill)(const CellArrays&, const CellMotion&, const BinArray&);
  void (*fillDirected)(const CellArrays&, const CellMotion&, const BinArray&);

  /** Forces of a smoothed field; the adjoint of filling. */
  CellForces (*forces)(const CellArrays&, const CellMotion&, const BinArray&);
  CellForces (*forcesDirected)(const CellArrays&, const CellMotion&, const BinArray&);

  /** Smooths along x.
   * \param[in] bins the first one of a run; rows on both sides are also read, as many
   * as the radius
   * \param[in] row bins from one x to the next
   * \param[in] size a multiple of four, here and below */
  void (*smoothAcross)(const float* bins,
                       std::int64_t row,
                       const SmoothingKernel&,
                       std::int64_t size,
                       float* out);

  /** Smooths along z, which gives q.
   * \param[in] bins the first one of a run; bins on both sides are also read, as many
   * as the radius
   * \param[out] out log2 q, and 0 where q is 0
   * \return sum of q log2 q */
  double (*takeLogarithms)(const float* bins,
                           const SmoothingKernel&,
                           std::int64_t size,
                           float* out);

  /** Smooths along z, as above, and subtracts the result from levels. */
  void (*takeFromLevels)(const float* bins,
                         const SmoothingKernel&,
                         const SmoothingLevels&,
                         std::int64_t size,
                         float* out);

  /** Adds each bin to its sum. \return sum of the bins */
  double (*sumUp)(const float* bins, std::int64_t size, double* sums);

  /** Replaces each q by log2 q; 0 is unchanged. \return sum of q log2 q */
  double (*takeExactLogarithms)(double* values, std::int64_t size);
};

extern const EntropyBins entropy_bins_base;
#ifdef ACMAP_SIMD_AVX2
extern const EntropyBins entropy_bins_avx2;
#endif

/** \brief The variant for this processor, or the one that the environment variable
 * ACMAP_SIMD selects ("base"). */
const EntropyBins&
entropyBins();

} // namespace pcl::acmap
