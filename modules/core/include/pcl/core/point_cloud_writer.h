#pragma once

#include <pcl/core/build_config.h>
#include <pcl/core/cloud_rows.h>
#include <pcl/core/exceptions.h>
#include <pcl/core/export.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl {

/** \brief Writes a cloud as binary PCD with all its fields but without padding.
 * \ref loadPointCloud reads back the same cloud, organized if it was.
 *
 * VIEWPOINT has 9 digits, which is enough for any float (PCL writes 6). The file is
 * written to a temporary file in the same folder and then renamed. For a mesh or a PLY
 * see \ref saveTriangleMesh.
 * \param[in] path file name with the extension .pcd (case-insensitive)
 * \param[in] cloud adjacent float32 x y z; metres, in the frame of the caller
 * \param[in] origin of the sensor, in the frame of the points
 * \param[in] orientation of the sensor, unit length
 * \throws OutputFileException when the file could not be written completely: another
 * extension, missing folder, no permission, disk full; an existing file of that name is
 * not changed
 * \throws BadArgumentException if there is no cloud, the fields are not inside the data, have a name that
 * a PCD cannot store, or x y z are missing; if the pose is not valid. \ingroup core */
ACMAP_EXPORT void
savePointCloud(const std::string& path,
               const CloudRows& cloud,
               const Eigen::Vector3f& origin = Eigen::Vector3f::Zero(),
               const Eigen::Quaternionf& orientation = Eigen::Quaternionf::Identity());

/** \brief The same for a cloud that is not shared. \ingroup core */
inline void
savePointCloud(const std::string& path,
               const PCLPointCloud2& cloud,
               const Eigen::Vector3f& origin = Eigen::Vector3f::Zero(),
               const Eigen::Quaternionf& orientation = Eigen::Quaternionf::Identity())
{
  savePointCloud(path, CloudRows::of(cloud), origin, orientation);
}

} // namespace pcl
