#include <pcl/core/impl/compiled_point_types.h>
#include <pcl/segmentation/impl/cylinder_hypothesis_clustering.hpp>
#include <pcl/segmentation/impl/depth_plane_segmentation.hpp>
#include <pcl/segmentation/impl/plane_hypothesis_clustering.hpp>

PCL_INSTANTIATE(CylinderHypothesisClustering, ACMAP_ALL_POINT_TYPES)
PCL_INSTANTIATE(PlaneHypothesisClustering, ACMAP_ALL_POINT_TYPES)
PCL_INSTANTIATE(DepthPlaneSegmentation, ACMAP_ALL_POINT_TYPES)
