#pragma once

#include <Eigen/Core>

namespace pcl::acmap {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/** \brief Normal equations of residuals r + J x of weight w, summed, for a small motion
 * x = (tx, ty, tz, rx, ry, rz) in the target's frame. */
struct NormalEquations {
  Matrix6 matrix = Matrix6::Zero();   ///< sum w J^T J, upper triangle
  Vector6 gradient = Vector6::Zero(); ///< sum w J^T r

  void
  add(const Vector6& row, double residual, double weight)
  {
    const Vector6 weighted = weight * row;
    matrix.triangularView<Eigen::Upper>() += weighted * row.transpose();
    gradient += weighted * residual;
  }

  void
  add(const NormalEquations& other, double factor = 1)
  {
    matrix += factor * other.matrix;
    gradient += factor * other.gradient;
  }
};

/** \brief Row of J for the residual along \a direction of a point that moves with the
 * frame. */
inline Vector6
motionRow(const Eigen::Vector3d& point, const Eigen::Vector3d& direction)
{
  Vector6 row;
  row << direction, point.cross(direction);
  return row;
}

} // namespace pcl::acmap
