#include "tree_search.h"

#include <cstdlib>
#include <string_view>

namespace pcl::acmap::dewall {

namespace {

const TreeSearch&
chooseVariant()
{
#ifdef ACMAP_SIMD_AVX2
  const char* asked = std::getenv("ACMAP_SIMD");
  if (!(asked && std::string_view(asked) == "base") && __builtin_cpu_supports("avx2"))
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
