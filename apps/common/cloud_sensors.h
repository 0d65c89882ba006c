#pragma once

#include <pcl/core/point_cloud_file.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Sensor positions of the observations that the int32 field `view` of a file's
 * cloud refers to, read from the `trajectory.txt` next to the file.
 * \param[in] path of the file that the cloud was read from
 * \param[in] scale metres in a unit of the trajectory
 * \param[in,out] remarks gets a line when there is no trajectory
 * \return metres; none for a cloud without that field
 * \throws InputFileException when the trajectory cannot be read */
std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 std::vector<std::string>& remarks);

} // namespace pcl::acmap
