#pragma once

#include "simulated_clouds.h"

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>

namespace pcl::acmap::bench {

/** \brief The coordinates alone, as PCL's point clouds. */
PointCloud<PointXYZ>::Ptr
plainPoints(const SimulatedCloud& cloud);

/** \brief With colour and view, as a map has them. */
PointCloud<PointXYZRGBNormalView>::Ptr
mapPoints(const SimulatedCloud& cloud);

} // namespace pcl::acmap::bench
