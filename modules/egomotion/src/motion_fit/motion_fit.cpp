#include "motion_fit/rotation_fit.h"

namespace pcl::acmap {

namespace {

/** Converts a motion about the centroids to a motion about the origin. */
Eigen::Isometry3d
motionOf(const Descent& found, const PairMoments& moments, MotionModel model)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = found.rotation.toRotationMatrix();
  motion.translation() =
      moments.target + moments.scale * found.offset - motion.linear() * moments.source;
  if (model == MotionModel::Planar)
    motion.translation().y() = 0;
  return motion;
}

double
energyOf(const Eigen::Isometry3d& motion,
         const std::vector<Eigen::Vector3d>& source,
         const std::vector<Eigen::Vector3d>& target,
         const std::vector<double>& weights)
{
  double energy = 0;
  for (std::size_t i = 0; i < source.size(); ++i)
    if (doesCount(source, target, weights, i))
      energy += weightOf(weights, i) * (target[i] - motion * source[i]).squaredNorm();
  return energy;
}

} // namespace

MotionFit
fitMotion(const std::vector<Eigen::Vector3d>& source,
          const std::vector<Eigen::Vector3d>& target,
          const std::vector<double>& weights,
          MotionModel model,
          MotionSolver solver)
{
  MotionFit fit;
  const PairMoments moments = pairMoments(source, target, weights);
  if (moments.scale == 0)
    return fit;
  Descent found;
  if (solver == MotionSolver::ClosedForm)
    found.rotation = closedFormRotation(moments, model);
  else {
    found = descend(moments, model);
    fit.has_converged = found.has_converged;
    fit.iterations = found.iterations;
  }
  fit.T_target_source = motionOf(found, moments, model);
  fit.energy = energyOf(fit.T_target_source, source, target, weights);
  return fit;
}

} // namespace pcl::acmap
