#include <pcl/core/compiled_point_types.h>
#include <pcl/mapping/impl/entropy_rectification.hpp>

PCL_INSTANTIATE(EntropyRectification, ACMAP_MAP_POINT_TYPES)
