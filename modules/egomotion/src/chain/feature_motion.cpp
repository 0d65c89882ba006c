#include "chain/feature_motion.h"

#include "chain/motion_step.h"

#include <algorithm>

namespace pcl::acmap {

namespace {

/** \brief Bound of an inlier: three standard deviations, for three degrees of freedom.
 */
constexpr double max_squared = 14.2;

/** \brief Weight of a pair. */
double
precisionOf(const FeaturePair& pair)
{
  return 1 / (pair.source_covariance.trace() + pair.target_covariance.trace());
}

/** \brief Eq. 2. */
Eigen::Isometry3d
leastSquaresMotion(const std::vector<FeaturePair>& pairs,
                   const std::vector<double>& weights,
                   MotionModel model,
                   MotionSolver solver)
{
  std::vector<Eigen::Vector3d> source, target;
  for (const FeaturePair& pair : pairs) {
    source.push_back(pair.source);
    target.push_back(pair.target);
  }
  return fitMotion(source, target, weights, model, solver).T_target_source;
}

/** \brief The motion with the minimum sum of distances, on which most pairs agree. */
Eigen::Isometry3d
medianMotion(const std::vector<FeaturePair>& pairs,
             MotionModel model,
             MotionSolver solver)
{
  constexpr int iterations = 10;
  constexpr double min_distance = 0.01; // metres
  std::vector<double> weights(pairs.size(), 1);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (int i = 0; i < iterations; ++i) {
    motion = leastSquaresMotion(pairs, weights, model, solver);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      weights[k] = 1 / std::max((motion * pairs[k].source - pairs[k].target).norm(),
                                min_distance);
  }
  return motion;
}

Eigen::Isometry3d
robustMotion(const std::vector<FeaturePair>& pairs,
             Eigen::Isometry3d T_target_source,
             MotionModel model)
{
  constexpr int max_iterations = 30;
  constexpr double min_step = 1e-7;
  for (int i = 0; i < max_iterations; ++i) {
    const Vector6 step =
        solvedStep(featureTerm(pairs, T_target_source).equations, model);
    T_target_source = afterStep(step, T_target_source);
    if (step.norm() < min_step)
      break;
  }
  return T_target_source;
}

/** \brief Sum of squared distances, each limited to the bound of an inlier, so that it
 * does not depend on how far away outliers are. */
double
misfit(const std::vector<FeaturePair>& pairs, const Eigen::Isometry3d& T_target_source)
{
  double sum = 0;
  for (const FeaturePair& pair : pairs)
    sum += std::min(squaredDistance(pair, T_target_source), max_squared);
  return sum;
}

/** \brief Returns the better result of two initial motions. With weights by precision,
 * near pairs dominate, which may belong to a person who walks by; with the minimum sum
 * of distances, the majority decides. */
Eigen::Isometry3d
bestMotion(const std::vector<FeaturePair>& pairs,
           MotionModel model,
           MotionSolver solver)
{
  std::vector<double> precisions;
  for (const FeaturePair& pair : pairs)
    precisions.push_back(precisionOf(pair));
  const Eigen::Isometry3d precise =
      robustMotion(pairs, leastSquaresMotion(pairs, precisions, model, solver), model);
  const Eigen::Isometry3d fair =
      robustMotion(pairs, medianMotion(pairs, model, solver), model);
  return misfit(pairs, fair) < misfit(pairs, precise) ? fair : precise;
}

} // namespace

FeatureMotion
featureMotion(const std::vector<FeaturePair>& pairs,
              MotionModel model,
              MotionSolver solver)
{
  FeatureMotion motion;
  motion.T_target_source = bestMotion(pairs, model, solver);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (squaredDistance(pairs[i], motion.T_target_source) < max_squared)
      motion.inliers.push_back(i);
  return motion;
}

} // namespace pcl::acmap
