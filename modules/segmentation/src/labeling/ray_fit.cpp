#include "labeling/ray_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <limits>

namespace pcl::acmap::labeling {

FitSums
movedSums(const FitSums& sums, const PlanePatch& from, const PlanePatch& to)
{
  const Eigen::Vector3d way = from.center - to.center;
  Eigen::Matrix3d terms = Eigen::Matrix3d::Identity(); // from old to new
  terms.row(0) << to.axis_u.dot(from.axis_u), to.axis_u.dot(from.axis_v),
      to.axis_u.dot(way);
  terms.row(1) << to.axis_v.dot(from.axis_u), to.axis_v.dot(from.axis_v),
      to.axis_v.dot(way);
  return {terms * sums.matrix * terms.transpose(), terms * sums.right};
}

bool
knowsTilt(const FitSums& sums, double maximum)
{
  const Eigen::Matrix3d covariance = sums.matrix.inverse();
  const auto isKnown = [&](double variance) { // false for NaN or < 0
    return variance >= 0 && variance <= maximum * maximum;
  };
  return isKnown(covariance(0, 0)) && isKnown(covariance(1, 1));
}

void
setFrame(const FitSums& sums, PlanePatch& patch)
{
  const Eigen::Matrix3d& m = sums.matrix;
  const Eigen::Vector2d mean = m.topRightCorner<2, 1>() / m(2, 2);
  const Eigen::Matrix2d spread =
      m.topLeftCorner<2, 2>() / m(2, 2) - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  const Eigen::Vector2d along = solver.eigenvectors().col(1);
  patch.center += mean[0] * patch.axis_u + mean[1] * patch.axis_v;
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  patch.axis_u = (along[0] * patch.axis_u + along[1] * patch.axis_v).normalized();
  patch.axis_v = normal.cross(patch.axis_u);
}

Eigen::Vector3d
moveToFit(const FitSums& sums, PlanePatch& patch)
{
  const Eigen::Vector3d solution = sums.matrix.ldlt().solve(sums.right);
  if (!solution.allFinite())
    return Eigen::Vector3d::Zero();
  const Eigen::Vector3d normal = patch.coefficients.head<3>();
  const Eigen::Vector3d turned =
      (normal - solution[0] * patch.axis_u - solution[1] * patch.axis_v)
          .stableNormalized();
  patch.center += solution[2] * normal;
  // in the plane, also after a large rotation
  patch.axis_u = (patch.axis_u + solution[0] * normal).stableNormalized();
  patch.axis_v = turned.cross(patch.axis_u);
  patch.coefficients << turned, -turned.dot(patch.center);
  return solution;
}

Eigen::Matrix3d
clusteredCovariance(const FitSums& sums,
                    double guess_weight,
                    const Eigen::Vector3d& solution,
                    const LargeVector<FitSums>& clusters)
{
  constexpr std::size_t min_clusters = 6;
  const Eigen::Matrix3d unknown =
      Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  if (clusters.size() < min_clusters)
    return unknown;
  const Eigen::Matrix3d inverse = sums.matrix.inverse();
  // This is a sum of squares, so that rounding cannot make a variance negative.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const FitSums& cluster : clusters) {
    const Eigen::Vector3d shift = inverse * (cluster.right - cluster.matrix * solution);
    covariance += shift * shift.transpose();
  }
  const double count = static_cast<double>(clusters.size());
  covariance *= count / (count - 3); // three fitted parameters
  for (const int slope : {0, 1})
    covariance += guess_weight * inverse.col(slope) * inverse.col(slope).transpose();
  return covariance.allFinite() ? covariance : unknown;
}

} // namespace pcl::acmap::labeling
