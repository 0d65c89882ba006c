#pragma once

#include <pcl/core/export.h>
#include <pcl/core/image_file.h>
#include <pcl/core/point_types.h>
#include <pcl/correspondence.h>
#include <pcl/point_cloud.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl {

/** \brief Draws two views side by side, the previous one on the left, with a line for
 * each match: in the upper part all matches by appearance, in red, in the lower part
 * the inliers of the motion, in green.
 * \param[in] now, before organized, of the same size
 * \param[in] matches, kept with `index_query` in now and `index_match` in before
 * \ingroup pipeline */
ACMAP_EXPORT RgbImage
matchPicture(const PointCloud<PointXYZRGBSigma>& now,
             const PointCloud<PointXYZRGBSigma>& before,
             const Correspondences& matches,
             const Correspondences& kept);

/** \brief Draws the trajectory of the camera from above, x to the right and z upwards,
 * with axes in metres: a line that starts at a dot, strokes for the directions of view,
 * dashed red lines with one cross per lost observation.
 * \param[in] poses T_map_camera of each observation; nothing if it is lost
 * \param[in] truth the true poses of all observations, drawn in grey; may be empty
 * \ingroup pipeline */
ACMAP_EXPORT RgbImage
trajectoryPicture(const std::vector<std::optional<Eigen::Isometry3d>>& poses,
                  const std::vector<Eigen::Isometry3d>& truth);

} // namespace pcl
