#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/core/export.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief Adds a uint32 field `label` to the cloud, which replaces an existing one: the
 * index of a plane + 1, 0 for none.
 * \param[in] planes index of the plane of each point, -1 for none
 * \throws BadArgumentException unless there is one for each point */
ACMAP_EXPORT PCLPointCloud2
withLabels(PCLPointCloud2 cloud, const std::vector<std::int32_t>& planes);

/** \brief Colours a cloud by its uint32 field `label` with 256 colours that are as
 * different as possible; grey where the label is 0.
 * \throws BadArgumentException when there is no such field */
ACMAP_EXPORT PCLPointCloud2
coloredByLabel(PCLPointCloud2 cloud);

} // namespace pcl::acmap
