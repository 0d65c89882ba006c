#pragma once

#include <pcl/conversions.h>
#include <pcl/core/impl/input_check.h>
#include <pcl/core/point_cloud_file.h>

#include <memory>

namespace pcl::acmap {

/** \brief A cloud of a point type with its sensor, copied, as one that was read from a file.
 * \throws InitFailedException without one, or if it claims other points than it has */
template <typename PointT>
std::shared_ptr<const PointCloudFile>
fileOf(const std::shared_ptr<const PointCloud<PointT>>& cloud)
{
  requireCloud(cloud);
  const auto file = std::make_shared<PointCloudFile>();
  toPCLPointCloud2(*cloud, file->cloud);
  file->sensor_origin = cloud->sensor_origin_.template head<3>();
  file->sensor_orientation = cloud->sensor_orientation_;
  return file;
}

} // namespace pcl::acmap
