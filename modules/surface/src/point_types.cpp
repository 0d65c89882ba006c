#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/surface/impl/dewall_triangulation.hpp>

// for MeshConstruction of our point types, see the header
#include <pcl/surface/impl/reconstruction.hpp>

template class pcl::MeshConstruction<pcl::PointXYZRGBNormalView>;
template class pcl::MeshConstruction<pcl::PointXYZRGBSigma>;

PCL_INSTANTIATE(DeWallTriangulation, ACMAP_ALL_POINT_TYPES)
