// The kernel compiled once more, for processors with AVX2. Only its own functions get
// these instructions: templates of the libraries may be merged with those of other
// sources, which run on any processor, so all their headers are included before.
#include <pcl/core/impl/disjoint_sets.h>
#include <pcl/core/impl/parallel.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/surface/impl/dewall_kernel.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <boost/multiprecision/cpp_int.hpp>
#include <oneapi/tbb/parallel_invoke.h>

#include <immintrin.h>

#include <atomic>
#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <sstream>
#include <thread>
#include <tuple>

#define ACMAP_DEWALL dewall_avx2
#define ACMAP_DEWALL_AVX2

// Its comparison could not be inlined into std::nth_element, which takes its time, if it
// had other instructions.
#include "dewall/point_tree.cpp"

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif

#include "dewall/apex_search.cpp"
#include "dewall/clusters.cpp"
#include "dewall/dewall_kernel.cpp"
#include "dewall/distinct_points.cpp"
#include "dewall/enclosed_volume.cpp"
#include "dewall/facing.cpp"
#include "dewall/fans.cpp"
#include "dewall/flat_patches.cpp"
#include "dewall/free_space.cpp"
#include "dewall/front.cpp"
#include "dewall/growing_mesh.cpp"
#include "dewall/joined_parts.cpp"
#include "dewall/last_passes.cpp"
#include "dewall/literal_builder.cpp"
#include "dewall/literal_mesh.cpp"
#include "dewall/literal_search.cpp"
#include "dewall/mesh_arrays.cpp"
#include "dewall/oriented_mesh.cpp"
#include "dewall/predicates.cpp"
#include "dewall/refill.cpp"
#include "dewall/ring_gaps.cpp"
#include "dewall/seed_test.cpp"
#include "dewall/size_constraint.cpp"
#include "dewall/small_holes.cpp"
#include "dewall/spacing.cpp"
#include "dewall/tree_search.cpp"
#include "dewall/triangle_builder.cpp"
#include "dewall/unused_points.cpp"

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
