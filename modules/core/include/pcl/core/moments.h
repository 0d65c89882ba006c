#pragma once

#include <pcl/core/export.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

/** \brief Sums of 1, p and p p^T over some points: all that a plane fit needs, and they
 * add up. The unit of length and the place of the origin are the holder's. \ingroup core
 */
struct Moments {
  double count = 0;
  double x = 0, y = 0, z = 0;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  Moments&
  operator+=(const Moments& other)
  {
    return addShifted(other, 0, 0, 0);
  }

  /** \brief Adds moments whose origin lies at (dx, dy, dz) of this one's frame. */
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

  /** \brief The same points in another unit of length. */
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

/** \brief Those of one point. */
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

/** \brief The plane of least squares through some points. */
struct PlaneFit {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< unit; its sign means nothing
  Eigen::Vector3d long_axis = Eigen::Vector3d::Zero(); ///< unit, of the most variance

  /** \brief Variances along the principal axes, ascending: the first one is that across
   * the plane. */
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();

  double count = 0;

  /** \brief Standard deviation across the plane, free of what the fit took away. */
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

/** \brief Fits by the smallest eigenvector of the covariance, in closed form.
 * \param[in] moments with a count of at least 1 */
ACMAP_EXPORT PlaneFit
fitPlane(const Moments& moments);

} // namespace pcl::acmap
