#pragma once

#include <pcl/core/point_cloud_file.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Positions of the observations that the int32 field `view` of a file's cloud refers
 * to: those of the `trajectory.txt` beside the file.
 * \param[in] path of the file that the cloud came from
 * \param[in] scale metres in a unit of the trajectory
 * \param[in,out] remarks gets a line where there is no trajectory
 * \return metres; none for a cloud without that field
 * \throws InputFileException when the trajectory cannot be read */
std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 std::vector<std::string>& remarks);

} // namespace pcl::acmap
