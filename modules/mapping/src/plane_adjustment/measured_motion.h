#pragma once

#include "pose_system.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

using Poses = std::vector<Eigen::Isometry3d>; ///< T_map_camera

/** \brief A measured relative pose of two views: an action of the odometry, or a
 * revisit. The first pose is fixed; pose i is row i - 1 of the equations. */
struct MeasuredMotion {
  std::size_t earlier = 0; ///< number of the view
  std::size_t later = 0;
  Eigen::Isometry3d T_earlier_later = Eigen::Isometry3d::Identity();

  /** \brief Difference of the motion between two poses from the measured one: rotation
   * vector, then translation, in the frame of the earlier view. */
  Vector6
  residual(const Poses& poses) const;

  /** \brief The squared residual in standard deviations. */
  double
  cost(const Poses& poses, const Matrix6& information) const
  {
    const Vector6 r = residual(poses);
    return r.dot(information * r);
  }

  /** \brief Adds to the normal equations.
   * \param[in,out] gradient one per row */
  void
  linearize(const Poses& poses,
            const Matrix6& information,
            PoseSystem& system,
            std::vector<Vector6>& gradient) const;

  /** \brief Covariance of the residual that follows from that of the poses.
   * \param[in] inverse of the equations, with this pair in its pattern */
  Matrix6
  covariance(const Poses& poses, const PoseSystem& inverse) const;

private:
  /** \brief Derivatives of the residual by the motions of the earlier and of the later
   * pose in their own frames. */
  struct Jacobians {
    Matrix6 earlier = Matrix6::Zero();
    Matrix6 later = Matrix6::Zero();
  };

  Jacobians
  jacobians(const Poses& poses) const;
};

} // namespace pcl::acmap
