#include "score_kernels.h"

#include <pcl/core/impl/simd_choice.h>

namespace pcl::acmap {

namespace {

RaiseScores
chooseVariant()
{
#ifdef ACMAP_SIMD_AVX2
  if (isAvx2Chosen())
    return raiseScoresAvx2;
#endif
  return raiseScoresBase;
}

} // namespace

RaiseScores
raiseScores()
{
  static const RaiseScores variant = chooseVariant();
  return variant;
}

} // namespace pcl::acmap
