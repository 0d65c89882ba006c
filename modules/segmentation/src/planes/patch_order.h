#pragma once

#include <pcl/segmentation/plane_clustering_kernel.h>

namespace pcl::acmap::planes {

/** Sorts the patches by falling area; the labels follow. */
void
sortByArea(PlaneClusters& clusters);

} // namespace pcl::acmap::planes
