#include <pcl/core/compiled_point_types.h>
#include <pcl/segmentation/impl/depth_plane_segmentation.hpp>

PCL_INSTANTIATE(DepthPlaneSegmentation, ACMAP_MAP_POINT_TYPES)
