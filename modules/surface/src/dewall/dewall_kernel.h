#pragma once

#include <pcl/surface/impl/dewall_kernel.h>

namespace pcl::acmap {

/** \brief The triangulation in the threads of the caller's arena; see
 * \ref triangulateDeWall. */
using DeWallKernel = TriangleMesh(const DeWallInput& input,
                                  const DeWallSettings& settings,
                                  const Progress& progress,
                                  DeWallReport& report);

namespace dewall {
DeWallKernel triangulate;
}

#ifdef ACMAP_SIMD_AVX2
namespace dewall_avx2 {
DeWallKernel triangulate;
}
#endif

} // namespace pcl::acmap
