#include "pair_kernels.h"

#include <pcl/core/impl/simd_choice.h>

namespace pcl::acmap {

namespace {

const PairKernels&
chooseVariant()
{
#ifdef ACMAP_SIMD_AVX2
  if (isAvx2Chosen())
    return pair_kernels_avx2;
#endif
  return pair_kernels_base;
}

} // namespace

const PairKernels&
pairKernels()
{
  static const PairKernels& variant = chooseVariant();
  return variant;
}

} // namespace pcl::acmap
