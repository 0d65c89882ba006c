#pragma once

#include <pcl/core/cloud_rows.h>
#include <pcl/core/export.h>
#include <pcl/core/plane_patch.h>
#include <pcl/core/scratch_memory.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace pcl {

/** \brief What is known of the poses of observations before their planes are looked at.
 * \ingroup pipeline */
struct PoseErrorModel {
  std::vector<Eigen::Isometry3d>
      poses; ///< T_map_camera, in the order of the observations
  /** \brief The same poses as the odometry has them, before they were rectified. Empty: those of
   * \ref poses are the odometry's. */
  std::vector<Eigen::Isometry3d> before{};
  OdometryNoise noise; ///< between each and the next one

  /** \brief The sensor moved level: poses err only along the floor and about this direction. None:
   * in six degrees of freedom. */
  std::optional<Eigen::Vector3d> up;
};

/** \brief Adds to the covariances of planes what the errors of the poses add
 * (PlanePatch::pose_modes).
 *
 * Poses and planes are the unknowns of a linear least squares problem: what an observation saw of a
 * plane is at the offset and the slopes that the plane has, and a pose follows from the one before
 * by the odometry. How well they agree is measured: by the offsets and the slopes of the points of
 * each observation with respect to the plane, and by how alike those of consecutive ones are. The joint covariance of all planes follows from the
 * inverse of the normal equations; its eight largest principal components are the modes, what is
 * left belongs to each plane alone.
 *
 * At most the 300 largest planes and 2000 observations; planes of which no observation has 200
 * points are left as they are, as are all if there are fewer than two observations.
 * \param[in] cloud points with the field `view`, metres, in the map frame
 * \param[in] labels plane of each point, -1 for none
 * \param[in,out] planes with covariances of independent noise alone \ingroup pipeline */
ACMAP_EXPORT void
addPoseErrors(const CloudRows& cloud,
              const PointLabels& labels,
              const PoseErrorModel& model,
              std::vector<PlanePatch>& planes);

} // namespace pcl
