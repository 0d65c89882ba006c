#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::acmap {

/** \brief A frame at a place of a plane: two axes along it, then its normal. */
struct PlaneFrame {
  /** \param[in] normal unit vector */
  PlaneFrame(const Eigen::Vector3d& normal, const Eigen::Vector3d& place)
  : origin(place)
  {
    axes.row(0) = normal.unitOrthogonal();
    axes.row(1) = normal.cross(Eigen::Vector3d(axes.row(0)));
    axes.row(2) = normal;
  }

  /** \brief Sums of [p; 1] [p; 1]^T in this frame from those in the frame of a pose. */
  Eigen::Matrix4d
  sumsOf(const Eigen::Matrix4d& cluster, const Eigen::Isometry3d& pose) const
  {
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
    local.topLeftCorner<3, 3>() = axes * pose.linear();
    local.topRightCorner<3, 1>() = axes * (pose.translation() - origin);
    return local * cluster * local.transpose();
  }

  Eigen::Matrix3d axes; ///< rows
  Eigen::Vector3d origin;
};

/** \brief Products of u, v, 1 in sums of a \ref PlaneFrame. */
inline Eigen::Matrix3d
heightProducts(const Eigen::Matrix4d& sums)
{
  const int use[3] = {0, 1, 3};
  Eigen::Matrix3d products;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      products(a, b) = sums(use[a], use[b]);
  return products;
}

/** \brief A regression of heights in a \ref PlaneFrame. */
struct HeightPlane {
  explicit HeightPlane(const Eigen::Matrix4d& sums)
  {
    const Eigen::Vector3d right(sums(0, 2), sums(1, 2), sums(3, 2));
    plane = heightProducts(sums).ldlt().solve(right);
    square = 1 + plane.head<2>().squaredNorm();
    cost = std::max(0.0, sums(2, 2) - plane.dot(right)) / square;
  }

  Eigen::Vector3d plane; ///< height = u, v, 1 times it
  double square;         ///< of the vector (-plane[0], -plane[1], 1)
  double cost;           ///< sum of the squared distances: chi^2
};

} // namespace pcl::acmap
