#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>

#include <string>

namespace pcl::acmap {

/** \brief An observation as it was read, and as pcl::VisualEgomotion takes it. */
struct EgomotionObservation {
  std::size_t index = 0; ///< place in the sequence
  PointCloudFile file;   ///< camera frame, metres
  PointCloud<PointXYZRGBSigma>::ConstPtr cloud;
};

/** \brief Reads an organized cloud with colour; `sigma` is 0 where it has none.
 * \param[in] scale metres in a unit of the file
 * \throws InputFileException when it cannot be read, is not organized, or has no colour */
EgomotionObservation
loadEgomotionObservation(const std::string& path, std::size_t index, double scale);

} // namespace pcl::acmap
