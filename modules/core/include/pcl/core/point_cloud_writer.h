#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/build_config.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl {

/** \brief Writes a cloud as binary PCD with all its fields, padding left out; what
 * \ref loadPointCloud reads back is the same cloud, organized if it was.
 *
 * VIEWPOINT has 9 digits, enough for any float (PCL writes 6). The file is written
 * beside its target and renamed into place. For a mesh or a PLY see
 * \ref saveTriangleMesh.
 * \param[in] path a name that ends in .pcd, in any case
 * \param[in] cloud x y z float32 side by side; metres, in the caller's frame
 * \param[in] origin of the sensor, in the frame of the points
 * \param[in] orientation of the sensor, unit length
 * \throws OutputFileException when the file could not be written whole: another ending,
 * missing folder, no permission, disk full; an older file of that name is then untouched
 * \throws BadArgumentException when the fields are not inside the data, have no name that
 * a PCD can hold, or x y z are missing; when the pose is none. \ingroup core */
ACMAP_EXPORT void
savePointCloud(const std::string& path,
               const PCLPointCloud2& cloud,
               const Eigen::Vector3f& origin = Eigen::Vector3f::Zero(),
               const Eigen::Quaternionf& orientation = Eigen::Quaternionf::Identity());

} // namespace pcl
