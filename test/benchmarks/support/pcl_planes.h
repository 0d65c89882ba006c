#pragma once

#include "plane_finders.h"

namespace pcl::acmap::bench {

/** \brief SACSegmentation with RANSAC, its fixed seed and optimised coefficients: finds
 * a plane, removes its points, and repeats until the next plane is too small. At the
 * end the planes are fitted to their points by least squares, like those of the other
 * methods. PCL selects the inliers again after its own fit, which gives three times
 * larger errors. */
FoundPlanes
sacPlanes(const PlaneInput& input);

/** \brief RegionGrowing with the normals of NormalEstimation; each region is fitted by
 * least squares. */
FoundPlanes
pclRegionPlanes(const PlaneInput& input);

} // namespace pcl::acmap::bench
