#include <pcl/core/compiled_point_types.h>
#include <pcl/surface/impl/dewall_triangulation.hpp>

PCL_INSTANTIATE(DeWallTriangulation, ACMAP_PCL_POINT_TYPES)
