#pragma once

#include <pcl/segmentation/plane_clustering_kernel.h>

namespace pcl::acmap::planes {

/** Sorts the patches by decreasing area and updates the labels. */
void
sortByArea(PlaneClusters& clusters);

} // namespace pcl::acmap::planes
