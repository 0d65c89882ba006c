#pragma once

#include <pcl/core/export.h>
#include <pcl/core/image_file.h>
#include <pcl/mapping/entropy_rectification_types.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <vector>

namespace pcl {

/** \brief Plans and energies of a rectification, as pictures. \ingroup pipeline */
struct RectificationPictures {
  RgbImage plan_before; ///< the map from above, see \ref PlanPicture
  RgbImage plan_after;  ///< the same part of it
  RgbImage plan;        ///< both, side by side
  RgbImage energy;      ///< see \ref energyPicture
};

/** \brief Draws the map before and after a rectification, and the energies of its search.
 * \param[in] clouds consolidated observations, sensor frame, metres
 * \param[in] before,after T_map_sensor of each cloud
 * \param[in] up direction in the map frame
 * \param[in] steps of the search, from the report of \ref EntropyRectification
 * \throws BadArgumentException if there are not as many poses as clouds \ingroup pipeline */
ACMAP_EXPORT RectificationPictures
drawRectification(const std::vector<PointCloud<PointNormal>::Ptr>& clouds,
                  const std::vector<Eigen::Isometry3d>& before,
                  const std::vector<Eigen::Isometry3d>& after,
                  const Eigen::Vector3d& up,
                  const std::vector<RectificationStep>& steps);

/** \brief Plots the energy over the steps of a search, with one colour per search.
 *
 * Energies are comparable only within one search and bin size: each is plotted relative
 * to the minimum of the comparable steps, and the line is interrupted between them.
 * Much higher energies are clipped. \ingroup pipeline */
ACMAP_EXPORT RgbImage
energyPicture(const std::vector<RectificationStep>& steps);

} // namespace pcl
