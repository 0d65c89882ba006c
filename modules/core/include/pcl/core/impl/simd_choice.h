#pragma once

#include <pcl/core/build_config.h>

#include <cstdlib>
#include <string_view>

namespace pcl::acmap {

/** \brief Returns true if kernels use their AVX2 variant: if the processor supports it,
 * and the environment variable ACMAP_SIMD is not "base". It is called once per kernel,
 * before its first run. \ingroup core */
inline bool
isAvx2Chosen()
{
#if defined(__x86_64__) || defined(__i386__)
  const char* asked = std::getenv("ACMAP_SIMD");
  return !(asked && std::string_view(asked) == "base") &&
         __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

} // namespace pcl::acmap
