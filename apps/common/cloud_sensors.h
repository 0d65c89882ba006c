#pragma once

#include <pcl/core/point_cloud_file.h>
#include <pcl/core/sensor_view.h>

#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Who saw the points of a file's cloud: those with an int32 field `view` were seen
 * from the poses of the `trajectory.txt` beside the file, others from the sensor of the
 * cloud. Valid as long as the cloud is unchanged.
 * \param[in] path of the file that the cloud came from
 * \param[in] scale metres in a unit of the trajectory
 * \param[in,out] remarks gets a line where there is no trajectory
 * \throws InputFileException when the trajectory cannot be read */
SensorView
sensorsOfFile(const PointCloudFile& file,
              const std::string& path,
              double scale,
              std::vector<std::string>& remarks);

} // namespace pcl::acmap
