#pragma once

#include "drawing.h"

#include <pcl/core/point_types.h>
#include <pcl/correspondence.h>
#include <pcl/point_cloud.h>

namespace pcl::acmap {

/** \brief Two views beside each other, the one before on the left, with a line from each
 * match to its fellow: above all that look alike, in red, below those that the motion
 * stands on, in green.
 * \param[in] now, before organized, of one size
 * \param[in] matches, kept with `index_query` in now and `index_match` in before */
RgbImage
matchPicture(const PointCloud<PointXYZRGBSigma>& now,
             const PointCloud<PointXYZRGBSigma>& before,
             const Correspondences& matches,
             const Correspondences& kept);

} // namespace pcl::acmap
