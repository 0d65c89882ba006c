#pragma once

#include <cstdint>

namespace pcl::acmap {

/** \brief Loops over the pixels of images, in variants as \ref PairKernels. */
struct ImageKernels {
  /** Computes grey levels, in 16ths, from red, green and blue. */
  void (*toGrey)(const std::uint8_t* colors, int count, std::int16_t* grey);

  /** Blurs a row along itself. \param[in] weights of the pixel, of those beside it, and
   * of the next ones; integers whose sum over both sides is 1024
   * \param[in] levels readable for 2 px beside the row */
  void (*blurAlong)(const float* levels, int width, const float* weights, float* out);

  /** Blurs five rows to one. */
  void (*blurAcross)(const float* const* rows,
                     int width,
                     const float* weights,
                     std::int16_t* out);

  /** Converts integers. */
  void (*toFloats)(const std::int16_t* from, int count, float* to);
};

extern const ImageKernels image_kernels_base;
extern const ImageKernels image_kernels_avx2;

/** \brief The variant for this processor. */
const ImageKernels&
imageKernels();

} // namespace pcl::acmap
