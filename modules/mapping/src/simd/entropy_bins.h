#pragma once

#include <cstdint>

namespace pcl::acmap {

/** \brief Bins of a grid, by layer, then x, then z. */
struct BinArray {
  float* bins = nullptr;
  std::int64_t row = 0;   ///< bins from one x to the next, a multiple of block
  std::int64_t layer = 0; ///< bins from one layer to the next

  /** Bins that are marked together. */
  static constexpr std::int64_t block = 4;

  std::uint8_t* marks = nullptr; ///< one a block; 1: something was filled in
};

/** \brief Cells as arrays, four or a multiple of it; no weight: only there to fill up. */
struct CellArrays {
  const float* x = nullptr; ///< bins, from the reference
  const float* z = nullptr;
  const float* weight = nullptr;
  const float* direction = nullptr; ///< layers of direction, in the sensor's frame
  std::int64_t size = 0;
};

/** \brief Where cells lie in a grid: cosine x + sine z + x0 bins from its beginning. */
struct CellMotion {
  double cosine = 1, sine = 0;
  double x0 = 0, z0 = 0; ///< bins, of the reference
  double turn = 0;       ///< layers of direction, added to those of the cells
};

/** \brief What cells feel: d / d bins and layers of direction, sums over the cells. */
struct CellForces {
  double x = 0, z = 0; ///< a bin
  double turn = 0;     ///< a radian, about the reference; places alone
  double layers = 0;   ///< a layer of direction
};

/** \brief A symmetric kernel, weights from its middle outwards: radius + 1. */
struct SmoothingKernel {
  const float* weights;
  std::int64_t radius;
};

/** \brief What smoothing is taken from: everywhere level + levels[j]. */
struct SmoothingLevels {
  float level;
  const float* levels;
};

/** \brief Loops that take most of the time, in variants for processors; all give the same
 * bytes.
 *
 * A cell is shared by 3 x 3 bins by quadratic B-splines; in the directed loops also by
 * three of eight layers of direction. */
struct EntropyBins {
  void (*fill)(const CellArrays&, const CellMotion&, const BinArray&);
  void (*fillDirected)(const CellArrays&, const CellMotion&, const BinArray&);

  /** Forces of a field that was smoothed; the reverse of filling. */
  CellForces (*forces)(const CellArrays&, const CellMotion&, const BinArray&);
  CellForces (*forcesDirected)(const CellArrays&, const CellMotion&, const BinArray&);

  /** Smooths along x. \param[in] bins the first of a run; also as many rows on each
   * side as the radius are read \param[in] row bins from one x to the next; \a size a
   * multiple of four, here and below */
  void (*smoothAcross)(const float* bins,
                       std::int64_t row,
                       const SmoothingKernel&,
                       std::int64_t size,
                       float* out);

  /** Smooths along z, which gives q. \param[in] bins the first of some; also those beside
   * them are read, as many as the radius on each side \param[out] out log2 q, and 0 where
   * q is 0 \return sum of q log2 q */
  double (*takeLogarithms)(const float* bins,
                           const SmoothingKernel&,
                           std::int64_t size,
                           float* out);

  /** Smooths along z, as above, and takes that from levels. */
  void (*takeFromLevels)(const float* bins,
                         const SmoothingKernel&,
                         const SmoothingLevels&,
                         std::int64_t size,
                         float* out);

  /** Adds bins to sums, one each. \return sum of the bins */
  double (*sumUp)(const float* bins, std::int64_t size, double* sums);

  /** Each q becomes log2 q, and 0 stays. \return sum of q log2 q */
  double (*takeExactLogarithms)(double* values, std::int64_t size);
};

extern const EntropyBins entropy_bins_base;
#ifdef ACMAP_SIMD_AVX2
extern const EntropyBins entropy_bins_avx2;
#endif

/** \brief The variant for this processor, or what the environment variable ACMAP_SIMD
 * names ("base"). */
const EntropyBins&
entropyBins();

} // namespace pcl::acmap
