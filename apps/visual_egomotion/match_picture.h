#pragma once

#include "drawing.h"

#include <pcl/core/point_types.h>
#include <pcl/correspondence.h>
#include <pcl/point_cloud.h>

namespace pcl::acmap {

/** \brief Draws two views side by side, the previous one on the left, with a line for
 * each match: in the upper part all matches by appearance, in red, in the lower part
 * the inliers of the motion, in green.
 * \param[in] now, before organized, of the same size
 * \param[in] matches, kept with `index_query` in now and `index_match` in before */
RgbImage
matchPicture(const PointCloud<PointXYZRGBSigma>& now,
             const PointCloud<PointXYZRGBSigma>& before,
             const Correspondences& matches,
             const Correspondences& kept);

} // namespace pcl::acmap
