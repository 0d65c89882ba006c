#include <pcl/core/compiled_point_types.h>
#include <pcl/filters/impl/depth_refinement.hpp>

PCL_INSTANTIATE(DepthRefinement, ACMAP_MAP_POINT_TYPES)
