#pragma once

#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl::acmap {

/** \brief Reads the pose of the sensor (VIEWPOINT) in the header of a PCD, but no point.
 * \throws InputFileException when the file or its header cannot be read */
ACMAP_EXPORT Eigen::Isometry3d
loadPcdViewpoint(const std::string& path);

} // namespace pcl::acmap
