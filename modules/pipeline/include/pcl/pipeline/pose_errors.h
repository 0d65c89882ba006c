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
 * The errors of poses and planes are the unknowns of a linear least squares problem: what an
 * observation saw of a plane is at the offset and the slopes that the plane has, and a pose follows
 * from the one before by the odometry, whose steps have errors of their own and one that all share.
 * Flat pieces of 25 cm of what is on no plane join observations in the same way. The scales of the
 * noise of the odometry and of what is seen are those of the residuals that are left.
 *
 * The map is not moved by the errors that this finds likely. What is told is therefore the mean
 * square of its errors: the joint covariance of all planes, plus the product of the likely errors.
 * Its eight largest principal components are the modes, what is left belongs to each plane alone.
 *
 * At most the 300 largest planes, 500 pieces and 2000 observations; an observation counts for a
 * plane from 200 points on that it sees from the side from which most were seen. Planes of which no
 * observation does are left as they are, as are all if there are fewer than two observations.
 * Complexity: linear in the points; a sparse factorization of six rounds.
 * \param[in] cloud points with the field `view`, metres, in the map frame
 * \param[in] labels plane of each point, -1 for none
 * \param[in,out] planes with covariances of independent noise alone
 * \throws BadArgumentException if the model has another number of poses before than of poses
 * \ingroup pipeline */
ACMAP_EXPORT void
addPoseErrors(const CloudRows& cloud,
              const PointLabels& labels,
              const PoseErrorModel& model,
              std::vector<PlanePatch>& planes);

} // namespace pcl
