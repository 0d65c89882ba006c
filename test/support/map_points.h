#pragma once

#include <pcl/common/io.h>
#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <memory>

namespace pcl::acmap::test {

/** \brief The point types for which the classes of maps are compiled. */
using MapPoints = testing::Types<PointXYZ,
                                 PointXYZI,
                                 PointXYZRGB,
                                 PointXYZRGBA,
                                 PointNormal,
                                 PointXYZRGBNormal,
                                 PointXYZRGBNormalView>;

/** \brief A cloud with the places of another one. */
template <typename PointT>
typename PointCloud<PointT>::Ptr
copyOf(const PointCloud<PointXYZ>& places)
{
  const auto cloud = std::make_shared<PointCloud<PointT>>();
  copyPointCloud(places, *cloud);
  return cloud;
}

} // namespace pcl::acmap::test
