#include <pcl/filters/impl/depth_refinement.hpp>

PCL_INSTANTIATE_DepthRefinement(pcl::PointXYZ)
    PCL_INSTANTIATE_DepthRefinement(pcl::PointXYZI)
        PCL_INSTANTIATE_DepthRefinement(pcl::PointXYZRGB)
            PCL_INSTANTIATE_DepthRefinement(pcl::PointXYZRGBA)
                PCL_INSTANTIATE_DepthRefinement(pcl::PointNormal)
                    PCL_INSTANTIATE_DepthRefinement(pcl::PointXYZRGBNormal)
                        PCL_INSTANTIATE_DepthRefinement(pcl::PointXYZRGBNormalView)
