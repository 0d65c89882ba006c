#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief The points of a cloud of unknown type, from its fields x, y and z.
 * \throws BadArgumentException without a cloud, if a field is missing or not a single
 * float, or if the data are shorter than the header declares */
std::vector<Eigen::Vector3f>
placesOf(const PCLPointCloud2::ConstPtr& cloud);

} // namespace pcl::acmap
