#include <pcl/core/compiled_point_types.h>
#include <pcl/mapping/impl/map_entropy.hpp>

PCL_INSTANTIATE(MapEntropy, ACMAP_MAP_POINT_TYPES)
