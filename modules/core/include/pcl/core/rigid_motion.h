#pragma once

#include <pcl/core/export.h>

#include <Eigen/Geometry>

namespace pcl::acmap {

/** \brief Largest deviation of the products of a rotation's axes from those of orthonormal
 * ones that is rounded away: chains of single precision stay far below. */
constexpr double pose_tolerance = 1e-3;

/** \brief Returns true if a pose is a rigid motion: finite, with an orthonormal rotation
 * without reflection.
 * \param[in] tolerance of the lengths and products of the axes
 * \ingroup core */
ACMAP_EXPORT bool
isRigid(const Eigen::Isometry3d& pose, double tolerance = pose_tolerance);

/** \brief A pose as programs have it: an isometry, an affine transformation or a 4 x 4
 * matrix of Eigen, of float or double, which may be the product of many. It is checked, and
 * its rotation made orthonormal if it deviates by more than 1e-9; a better one stays as it
 * is, bit by bit. Metres. \ingroup core */
class ACMAP_EXPORT RigidMotion {
public:
  /** \throws BadArgumentException naming what is wrong: a value that is not finite,
   * a last row other than 0 0 0 1, a reflection, a deviation from orthonormal
   * axes above \ref pose_tolerance */
  template <typename Scalar, int mode, int options>
  RigidMotion(const Eigen::Transform<Scalar, 3, mode, options>& pose)
  : RigidMotion(Eigen::Transform<Scalar, 3, Eigen::Affine>(pose).matrix())
  {}

  /** \throws the same */
  template <typename Derived>
  RigidMotion(const Eigen::MatrixBase<Derived>& pose)
  : pose_(rigid(pose.template cast<double>()))
  {}

  operator const Eigen::Isometry3d&() const
  {
    return pose_;
  }

  const Eigen::Isometry3d&
  get() const
  {
    return pose_;
  }

private:
  static Eigen::Isometry3d
  rigid(const Eigen::Matrix4d& pose);

  Eigen::Isometry3d pose_;
};

/** \brief Returns the pose if it is one of a map.
 * \throws BadArgumentException if it is more than 1e9 m from the origin along an axis */
ACMAP_EXPORT const RigidMotion&
requirePlace(const RigidMotion& pose);

} // namespace pcl::acmap

namespace pcl {

using acmap::isRigid;

}
