#pragma once

#include <pcl/core/point_cloud_file.h>

#include <string>

namespace pcl::acmap {

/** \brief Reads a cloud and multiplies its lengths by a factor.
 * \param[in] path the file
 * \param[in] scale metres per unit of the file
 * \throws InputFileException as \ref pcl::loadPointCloud */
ACMAP_EXPORT PointCloudFile
loadScaledCloud(const std::string& path, double scale);

/** \brief Multiplies x, y, z and `sigma` of all points and the position of the sensor
 * by a factor. */
ACMAP_EXPORT void
scaleCloud(PointCloudFile& file, double scale);

} // namespace pcl::acmap
