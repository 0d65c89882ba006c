#include <pcl/core/compiled_point_types.h>
#include <pcl/texture/impl/plane_texturing.hpp>

PCL_INSTANTIATE(PlaneTexturing, ACMAP_MAP_POINT_TYPES)
