#include "entropy_bins.h"

#include <pcl/core/impl/simd_choice.h>

namespace pcl::acmap {

namespace {

const EntropyBins&
chooseVariant()
{
#ifdef ACMAP_SIMD_AVX2
  if (isAvx2Chosen())
    return entropy_bins_avx2;
#endif
  return entropy_bins_base;
}

} // namespace

const EntropyBins&
entropyBins()
{
  static const EntropyBins& variant = chooseVariant();
  return variant;
}

} // namespace pcl::acmap
