#include "pair_kernels.h"

#include "byte_kernels.h"
#include "image_kernels.h"

#include <pcl/core/impl/simd_choice.h>

namespace pcl::acmap {

const PairKernels&
pairKernels()
{
#ifdef ACMAP_SIMD_AVX2
  static const PairKernels& variant =
      isAvx2Chosen() ? pair_kernels_avx2 : pair_kernels_base;
  return variant;
#else
  return pair_kernels_base;
#endif
}

const ByteKernels&
byteKernels()
{
#ifdef ACMAP_SIMD_AVX2
  static const ByteKernels& variant =
      isAvx2Chosen() ? byte_kernels_avx2 : byte_kernels_base;
  return variant;
#else
  return byte_kernels_base;
#endif
}

const ImageKernels&
imageKernels()
{
#ifdef ACMAP_SIMD_AVX2
  static const ImageKernels& variant =
      isAvx2Chosen() ? image_kernels_avx2 : image_kernels_base;
  return variant;
#else
  return image_kernels_base;
#endif
}

} // namespace pcl::acmap
