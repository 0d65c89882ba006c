#pragma once

#include <pcl/core/export.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

/** \brief Sums of 1, p and p p^T over some points, which is all that a plane fit needs;
 * they are additive. Unit of length and origin are defined by the user of the class.
 * \ingroup core */
struct Moments {
  double count = 0;
  double x = 0, y = 0, z = 0;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  Moments&
  operator+=(const Moments& other)
  {
    return addShifted(other, 0, 0, 0);
  }

  /** \brief Adds moments whose origin is at (dx, dy, dz) in the frame of this object.
   */
  Moments&
  addShifted(const Moments& other, double dx, double dy, double dz)
  {
    const double n = other.count;
    count += n;
    xx += other.xx + dx * (2 * other.x + n * dx);
    xy += other.xy + dx * other.y + dy * (other.x + n * dx);
    xz += other.xz + dx * other.z + dz * (other.x + n * dx);
    yy += other.yy + dy * (2 * other.y + n * dy);
    yz += other.yz + dy * other.z + dz * (other.y + n * dy);
    zz += other.zz + dz * (2 * other.z + n * dz);
    x += other.x + n * dx;
    y += other.y + n * dy;
    z += other.z + n * dz;
    return *this;
  }

  /** \brief Returns the moments of the same points in another unit of length. */
  Moments
  scaled(double factor) const
  {
    const double square = factor * factor;
    return {count,
            x * factor,
            y * factor,
            z * factor,
            xx * square,
            xy * square,
            xz * square,
            yy * square,
            yz * square,
            zz * square};
  }

  Eigen::Vector3d
  mean() const
  {
    return Eigen::Vector3d(x, y, z) / count;
  }
};

/** \brief Moments of one point. */
inline Moments
momentsOf(const Eigen::Vector3d& p)
{
  return {1,
          p.x(),
          p.y(),
          p.z(),
          p.x() * p.x(),
          p.x() * p.y(),
          p.x() * p.z(),
          p.y() * p.y(),
          p.y() * p.z(),
          p.z() * p.z()};
}

/** \brief The least-squares plane of some points. */
struct PlaneFit {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit; its sign is arbitrary
  /** \brief Unit vector in the direction of maximum variance. */
  Eigen::Vector3d long_axis = Eigen::Vector3d::Zero();

  /** \brief Variances along the principal axes in ascending order: the first one is
   * across the plane. */
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();

  double count = 0;

  /** \brief Standard deviation across the plane, corrected for the degrees of freedom
   * of the fit. */
  double
  thickness() const
  {
    return std::sqrt(variances[0] * count / std::max(count - 3, 1.0));
  }

  /** \brief Is it a plane rather than a line, a point or a ball? */
  bool
  isPlanar() const
  {
    return count >= 4 && variances[1] > 10 * variances[0] &&
           variances[1] > 1e-3 * variances[2];
  }
};

/** \brief Fits a plane by the smallest eigenvector of the covariance, in closed form.
 * \param[in] moments with a count of at least 1 */
ACMAP_EXPORT PlaneFit
fitPlane(const Moments& moments);

} // namespace pcl::acmap
