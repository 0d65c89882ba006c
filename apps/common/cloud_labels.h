#pragma once

#include "stage_log.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/point_cloud_file.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Adds a uint32 field `label` to the cloud, which replaces an existing one: the
 * index of a plane + 1, 0 for none.
 * \param[in] planes index of the plane of each point, -1 for none */
PCLPointCloud2
withLabels(PCLPointCloud2 cloud, const std::vector<std::int32_t>& planes);

/** \brief Colours a cloud by its uint32 field `label` with 256 colours that are as
 * different as possible; grey where the label is 0.
 * \throws UsageError when there is no such field */
PCLPointCloud2
coloredByLabel(PCLPointCloud2 cloud);

/** \brief Sensor positions of the observations that the int32 field `view` of a file's
 * cloud refers to: those of the file, or of the `trajectory.txt` next to it; a warning when
 * there are none.
 * \param[in] path of the file that the cloud was read from
 * \param[in] scale metres in a unit of the trajectory
 * \return metres; none for a cloud without that field
 * \throws InputFileException when the trajectory cannot be read */
std::vector<Eigen::Vector3f>
viewpointsOfFile(const PointCloudFile& file,
                 const std::string& path,
                 double scale,
                 StageLog& log);

} // namespace pcl::acmap
