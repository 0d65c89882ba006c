#pragma once

#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief SACSegmentation by RANSAC, with its fixed seed and optimised coefficients: finds
 * a plane, takes its points away, and so on until the next one is too small. In the end
 * the planes are fitted by least squares to what they took, as the others' are: PCL chooses
 * inliers anew after its own fit, and is three times as far off. */
FoundPlanes
sacPlanes(const PlaneInput& input);

/** \brief RegionGrowing on the normals of NormalEstimation, each region fitted by least
 * squares. */
FoundPlanes
pclRegionPlanes(const PlaneInput& input);

} // namespace pcl::acmap::bench
