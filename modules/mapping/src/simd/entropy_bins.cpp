#include "entropy_bins.h"

#include <cstdlib>
#include <string_view>

namespace pcl::acmap {

namespace {

const EntropyBins&
chooseVariant()
{
#ifdef ACMAP_SIMD_AVX2
  const char* asked = std::getenv("ACMAP_SIMD");
  if (!(asked && std::string_view(asked) == "base") && __builtin_cpu_supports("avx2"))
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
