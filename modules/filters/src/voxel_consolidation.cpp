#include <pcl/core/compiled_point_types.h>
#include <pcl/filters/impl/voxel_consolidation.hpp>

PCL_INSTANTIATE(VoxelConsolidation, ACMAP_ALL_POINT_TYPES)
