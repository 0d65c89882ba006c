#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <vector>

namespace pcl::acmap {

/** \brief The cloud with a uint32 field `label`, which replaces an older one: the number
 * of a plane + 1, 0 for none.
 * \param[in] planes for each point the number of its plane, -1 for none */
PCLPointCloud2
withLabels(PCLPointCloud2 cloud, const std::vector<std::int32_t>& planes);

/** \brief The cloud in colours by its uint32 field `label`, as different as 256 can be;
 * grey where the label is 0.
 * \throws UsageError when there is no such field */
PCLPointCloud2
coloredByLabel(PCLPointCloud2 cloud);

} // namespace pcl::acmap
