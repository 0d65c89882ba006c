#pragma once

#include "simulated_clouds.h"

#include <pcl/core/point_types.h>
#include <pcl/point_cloud.h>

namespace pcl::acmap::bench {

/** \brief Only the coordinates, as a PCL cloud. */
PointCloud<PointXYZ>::Ptr
plainPoints(const SimulatedCloud& cloud);

/** \brief Points with colour and view, as in a map. */
PointCloud<PointXYZRGBNormalView>::Ptr
mapPoints(const SimulatedCloud& cloud);

} // namespace pcl::acmap::bench
