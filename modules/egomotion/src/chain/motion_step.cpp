#include "chain/motion_step.h"

#include <pcl/core/impl/rotation_vector.h>

#include <Eigen/Eigenvalues>

#include <limits>

namespace pcl::acmap {

namespace {

using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/** \brief Minimum information on a metre or a radian; less counts as undetermined. */
constexpr double min_information = 1e-6;

struct Spectrum {
  Basis basis;
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

Spectrum
spectrumOf(const NormalEquations& equations, MotionModel model)
{
  Spectrum spectrum;
  spectrum.basis = motionBasis(model);
  const Matrix6 whole = equations.matrix.selfadjointView<Eigen::Upper>();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      spectrum.basis.transpose() * whole * spectrum.basis);
  spectrum.values = solver.eigenvalues();
  spectrum.vectors = solver.eigenvectors();
  return spectrum;
}

} // namespace

Basis
motionBasis(MotionModel model)
{
  if (model == MotionModel::Rigid)
    return Matrix6::Identity();
  Basis basis = Basis::Zero(6, 3);
  basis(0, 0) = basis(2, 1) = basis(4, 2) = 1;
  return basis;
}

Vector6
solvedStep(const NormalEquations& equations, MotionModel model)
{
  const Spectrum spectrum = spectrumOf(equations, model);
  Eigen::VectorXd along =
      spectrum.vectors.transpose() * (spectrum.basis.transpose() * equations.gradient);
  for (Eigen::Index i = 0; i < along.size(); ++i)
    along[i] =
        spectrum.values[i] > min_information ? -along[i] / spectrum.values[i] : 0;
  return spectrum.basis * (spectrum.vectors * along);
}

Matrix6
covarianceOf(const NormalEquations& equations, MotionModel model)
{
  const Spectrum spectrum = spectrumOf(equations, model);
  if (!(spectrum.values.minCoeff() > min_information)) {
    const Matrix6 open = spectrum.basis * spectrum.basis.transpose();
    return (open.array() != 0)
        .select(Matrix6::Constant(std::numeric_limits<double>::infinity()), 0.0);
  }
  const Basis turned = spectrum.basis * spectrum.vectors;
  return turned * spectrum.values.cwiseInverse().asDiagonal() * turned.transpose();
}

Matrix6
covarianceOf(const NormalEquations& equations,
             const Matrix6& scatter,
             MotionModel model)
{
  const Matrix6 independent = covarianceOf(equations, model);
  if (!independent.allFinite())
    return independent;
  return independent + independent * scatter * independent;
}

Eigen::Isometry3d
afterStep(const Vector6& step, const Eigen::Isometry3d& pose)
{
  Eigen::Isometry3d motion(rotationOf(step.tail<3>()));
  motion.translation() = step.head<3>();
  Eigen::Isometry3d moved = motion * pose;
  moved.linear() = Eigen::Quaterniond(moved.linear()).normalized().toRotationMatrix();
  return moved;
}

} // namespace pcl::acmap
