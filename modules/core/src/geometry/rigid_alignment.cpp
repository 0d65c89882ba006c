#include <pcl/core/impl/rigid_alignment.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace pcl::acmap {

template <int Dimension>
Eigen::Matrix<double, Dimension, Dimension>
alignmentRotation(const Eigen::Matrix<double, Dimension, Dimension>& cross,
                  double undetermined)
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
      return smallestRotation(v.col(0), u.col(0)).toRotationMatrix();
  if (u.determinant() * v.determinant() < 0)
    u.col(Dimension - 1) *= -1;
  return u * v.transpose();
}

template ACMAP_EXPORT Eigen::Matrix2d
alignmentRotation<2>(const Eigen::Matrix2d&, double);
template ACMAP_EXPORT Eigen::Matrix3d
alignmentRotation<3>(const Eigen::Matrix3d&, double);

Eigen::Quaterniond
smallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1 + Eigen::NumTraits<double>::dummy_precision())
    return Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, a.unitOrthogonal()));
  const double twice = std::sqrt((1 + cosine) * 2);
  Eigen::Quaterniond rotation;
  rotation.vec() = a.cross(b) * (1 / twice);
  rotation.w() = twice / 2;
  return rotation;
}

} // namespace pcl::acmap
