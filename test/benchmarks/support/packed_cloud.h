#pragma once

#include <pcl/core/point_cloud_file.h>

#include <string>

namespace pcl::acmap::bench {

/** \brief Reads a cloud; a file that ends in .xz is unpacked by the program xz first.
 * \throws InputFileException as loadPointCloud, and if it could not be unpacked */
PointCloudFile
loadMaybePacked(const std::string& path);

} // namespace pcl::acmap::bench
