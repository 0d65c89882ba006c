#include <pcl/core/impl/moments.h>

#include <Eigen/Eigenvalues>

namespace pcl::acmap {

PlaneFit
fitPlane(const Moments& moments)
{
  PlaneFit fit;
  fit.count = moments.count;
  fit.mean = moments.mean();
  Eigen::Matrix3d covariance;
  covariance << moments.xx, moments.xy, moments.xz, // symmetric
      moments.xy, moments.yy, moments.yz,           //
      moments.xz, moments.yz, moments.zz;
  covariance = covariance / moments.count - fit.mean * fit.mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  fit.variances = solver.eigenvalues().cwiseMax(0.0);
  fit.normal = solver.eigenvectors().col(0);
  fit.long_axis = solver.eigenvectors().col(2);
  return fit;
}

} // namespace pcl::acmap
