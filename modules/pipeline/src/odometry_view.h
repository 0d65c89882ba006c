#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <memory>

namespace pcl::acmap {

/** \brief An observation of a sequence as input of pcl::VisualEgomotion. */
struct OdometryView {
  std::size_t index = 0;                      ///< index in the sequence
  std::shared_ptr<const PointCloudFile> file; ///< camera frame, metres
  PointCloud<PointXYZRGBSigma>::ConstPtr cloud;
};

} // namespace pcl::acmap
