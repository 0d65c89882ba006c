#include "tree_search.h"

#include <pcl/core/impl/simd_choice.h>

namespace pcl::acmap::dewall {

namespace {

const TreeSearch&
chooseVariant()
{
#ifdef ACMAP_SIMD_AVX2
  if (isAvx2Chosen())
    return tree_search_avx2;
#endif
  return tree_search_base;
}

} // namespace

const TreeSearch&
treeSearch()
{
  static const TreeSearch& variant = chooseVariant();
  return variant;
}

} // namespace pcl::acmap::dewall
