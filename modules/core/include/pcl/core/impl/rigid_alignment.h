#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace pcl::acmap {

/** \brief The rotation that aligns points with others in the least-squares sense
 * (Kabsch, Umeyama); never a reflection.
 *
 * Points that coincide do not determine a rotation, and points on a line in space
 * determine it up to a turn about the line: then it is the smallest one.
 * \param[in] cross sum of target * source^T over the pairs of points, both relative to
 * their centroids
 * \param[in] undetermined singular values up to this one are regarded as 0
 * \return R, for which R * source is closest to target \ingroup core */
template <int Dimension>
Eigen::Matrix<double, Dimension, Dimension>
alignmentRotation(const Eigen::Matrix<double, Dimension, Dimension>& cross,
                  double undetermined = 0)
{
  static_assert(Dimension == 2 || Dimension == 3);
  using Square = Eigen::Matrix<double, Dimension, Dimension>;
  const Eigen::JacobiSVD<Square> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Square u = svd.matrixU();
  const Square& v = svd.matrixV();
  if (svd.singularValues()[0] <= undetermined)
    return Square::Identity();
  if constexpr (Dimension == 3)
    if (svd.singularValues()[1] <= undetermined)
      return Eigen::Quaterniond::FromTwoVectors(v.col(0), u.col(0)).toRotationMatrix();
  if (u.determinant() * v.determinant() < 0)
    u.col(Dimension - 1) *= -1;
  return u * v.transpose();
}

} // namespace pcl::acmap
