#include <pcl/filters/impl/voxel_consolidation.hpp>

PCL_INSTANTIATE_VoxelConsolidation(pcl::PointXYZ)
    PCL_INSTANTIATE_VoxelConsolidation(pcl::PointXYZI)
        PCL_INSTANTIATE_VoxelConsolidation(pcl::PointXYZRGB)
            PCL_INSTANTIATE_VoxelConsolidation(pcl::PointXYZRGBA)
                PCL_INSTANTIATE_VoxelConsolidation(pcl::PointNormal)
                    PCL_INSTANTIATE_VoxelConsolidation(pcl::PointXYZRGBNormal)
                        PCL_INSTANTIATE_VoxelConsolidation(pcl::PointXYZRGBNormalView)
