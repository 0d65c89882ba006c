#include "score_kernels.h"

#include <pcl/core/impl/simd_choice.h>

namespace pcl::acmap {

namespace {

struct Variants {
  FindPairs find = findPairsBase;
  ProductOf product = productOfBase;
};

Variants
chooseVariants()
{
#ifdef ACMAP_SIMD_AVX2
  if (isAvx2Chosen())
    return {findPairsAvx2, productOfAvx2};
#endif
  return {};
}

const Variants&
variants()
{
  static const Variants chosen = chooseVariants();
  return chosen;
}

} // namespace

FindPairs
findPairs()
{
  return variants().find;
}

ProductOf
productOf()
{
  return variants().product;
}

} // namespace pcl::acmap
