#include "chain/egomotion_failure.h"
#include "chain/estimate_from_pairs.h"
#include "chain/feature_pairs.h"
#include "chain/motion_step.h"
#include "chain/refinement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pcl::acmap {

namespace {

/** \brief The motion of matched features. */
struct FeatureMotion {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  std::vector<std::size_t> inliers; ///< indices of the pairs
};

/** \brief Bound of an inlier: three standard deviations, for three degrees of freedom.
 */
constexpr double max_squared = 14.2;

/** \brief Weight of a pair. */
double
precisionOf(const FeaturePair& pair)
{
  return 1 / (pair.source_covariance.trace() + pair.target_covariance.trace());
}

/** \brief Minimises Eq. 2 and counts how often. */
class MotionFitter {
public:
  MotionFitter(MotionModel model, MotionSolver solver, EgomotionReport& report)
  : model_(model)
  , solver_(solver)
  , report_(report)
  {}

  MotionModel
  model() const
  {
    return model_;
  }

  /** \param[in] weights one per pair; if empty, all are 1 */
  MotionFit
  fit(const std::vector<FeaturePair>& pairs, const std::vector<double>& weights) const
  {
    std::vector<Eigen::Vector3d> source, target;
    for (const FeaturePair& pair : pairs) {
      source.push_back(pair.source);
      target.push_back(pair.target);
    }
    MotionFit fit = fitMotion(source, target, weights, model_, solver_);
    ++report_.fits;
    report_.iterations += fit.iterations;
    return fit;
  }

private:
  MotionModel model_;
  MotionSolver solver_;
  EgomotionReport& report_;
};

/** \brief The motion with the minimum sum of distances, on which most pairs agree. */
Eigen::Isometry3d
medianMotion(const std::vector<FeaturePair>& pairs, const MotionFitter& fitter)
{
  constexpr int iterations = 10;
  constexpr double min_distance = 0.01; // metres
  std::vector<double> weights(pairs.size(), 1);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (int i = 0; i < iterations; ++i) {
    motion = fitter.fit(pairs, weights).T_target_source;
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
bestMotion(const std::vector<FeaturePair>& pairs, const MotionFitter& fitter)
{
  std::vector<double> precisions;
  for (const FeaturePair& pair : pairs)
    precisions.push_back(precisionOf(pair));
  const Eigen::Isometry3d precise = robustMotion(
      pairs, fitter.fit(pairs, precisions).T_target_source, fitter.model());
  const Eigen::Isometry3d fair =
      robustMotion(pairs, medianMotion(pairs, fitter), fitter.model());
  return misfit(pairs, fair) < misfit(pairs, precise) ? fair : precise;
}

/** \brief Eq. 2 by conjugate gradient, with weights of 1 / sigma^2, then robust least
 * squares with full covariances. The second step is repeated from the motion with the
 * minimum sum of distances, and the better result is returned. */
FeatureMotion
featureMotion(const std::vector<FeaturePair>& pairs, const MotionFitter& fitter)
{
  FeatureMotion motion;
  motion.T_target_source = bestMotion(pairs, fitter);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (squaredDistance(pairs[i], motion.T_target_source) < max_squared)
      motion.inliers.push_back(i);
  return motion;
}

PixelPairs
pixelsOf(const std::vector<FeaturePair>& pairs)
{
  PixelPairs pixels;
  for (const FeaturePair& pair : pairs)
    pixels.emplace_back(pair.source_pixel, pair.target_pixel);
  return pixels;
}

/** \brief Covariance of the motion of a fit with equal weights, from its residuals. */
Matrix6
covarianceOfFit(const std::vector<FeaturePair>& pairs,
                const MotionFit& fit,
                MotionModel model)
{
  NormalEquations equations;
  for (const FeaturePair& pair : pairs) {
    const Eigen::Vector3d point = fit.T_target_source * pair.source;
    for (int axis = 0; axis < 3; ++axis)
      equations.add(motionRow(point, Eigen::Vector3d::Unit(axis)),
                    point[axis] - pair.target[axis],
                    1);
  }
  const Matrix6 covariance = covarianceOf(equations, model);
  const double freedoms = 3 * static_cast<double>(pairs.size()) -
                          static_cast<double>(motionBasis(model).cols());
  // infinite elements must remain so without residuals
  return covariance.allFinite() ? Matrix6(fit.energy / freedoms * covariance)
                                : covariance;
}

EgomotionFailure
fewMatches(std::size_t matches, std::size_t needed)
{
  return {EgomotionOutcome::FewMatches,
          std::to_string(matches) + " keypoints look alike, at least " +
              std::to_string(needed) + " are needed"};
}

EgomotionFailure
noAgreement(std::size_t agreeing, std::size_t matches)
{
  return {EgomotionOutcome::Inconsistent,
          "only " + std::to_string(agreeing) + " of " + std::to_string(matches) +
              " matches agree on a motion: so few may agree by chance"};
}

/** \brief Minimum number of matches; in paper mode those that determine a motion. */
std::size_t
minMatches(const EgomotionSettings& settings)
{
  if (!settings.paper)
    return min_features;
  return settings.model == MotionModel::Planar ? 2 : 3;
}

/** \brief The steps of II-B.1. Each returns a failure if the next one is not possible.
 */
class EgomotionSteps {
public:
  EgomotionSteps(const EgomotionView& source,
                 const EgomotionView& target,
                 const EgomotionSettings& settings,
                 EgomotionReport& report)
  : source_(source)
  , target_(target)
  , settings_(settings)
  , report_(report)
  , fitter_(settings.model, settings.solver, report)
  {}

  std::optional<EgomotionFailure>
  match(const std::vector<FeaturePair>& alike, EgomotionSolution& solution)
  {
    alike_ = alike;
    solution.matches = pixelsOf(alike_);
    report_.matches = alike_.size();
    if (alike_.size() < minMatches(settings_))
      return fewMatches(alike_.size(), minMatches(settings_));
    return std::nullopt;
  }

  /** \brief Eq. 1. */
  std::optional<EgomotionFailure>
  leaveOut()
  {
    consistent_ = consistentPairs(alike_, settings_.worst_out);
    report_.consistent = consistent_.size();
    report_.removed = alike_.size() - consistent_.size();
    if (consistent_.size() < minMatches(settings_))
      return noAgreement(consistent_.size(), alike_.size());
    return std::nullopt;
  }

  std::optional<EgomotionFailure>
  fit(EgomotionSolution& solution)
  {
    const FeatureMotion motion = featureMotion(consistent_, fitter_);
    T_target_source_ = motion.T_target_source;
    for (const std::size_t i : motion.inliers)
      inliers_.push_back(consistent_[i]);
    solution.inliers = pixelsOf(inliers_);
    report_.inliers = inliers_.size();
    if (!isAgreement(inliers_.size(), alike_.size()))
      return noAgreement(inliers_.size(), alike_.size());
    return std::nullopt;
  }

  /** \brief The paper's last step: Eq. 2 in one fit, with B_ij = 1 for all matches that
   * remain. */
  std::optional<EgomotionFailure>
  fitOnce(EgomotionSolution& solution)
  {
    solution.inliers = pixelsOf(consistent_);
    report_.inliers = consistent_.size();
    const MotionFit fit = fitter_.fit(consistent_, {});
    report_.feature_residual =
        std::sqrt(fit.energy / static_cast<double>(consistent_.size()));
    if (!fit.has_converged)
      report_.remarks.push_back("Eq. 2 had not converged after " +
                                std::to_string(fit.iterations) + " iterations");
    const Matrix6 covariance = covarianceOfFit(consistent_, fit, settings_.model);
    if (!covariance.allFinite())
      return EgomotionFailure{EgomotionOutcome::Unobservable,
                              "the matches that remain lie on one line and leave a "
                              "rotation open"};
    const PlanarPose pose = planarPartOf(fit.T_target_source);
    solution.estimate = {fit.T_target_source, {pose.x, pose.z, pose.theta}, covariance};
    return std::nullopt;
  }

  std::optional<EgomotionFailure>
  refine(EgomotionSolution& solution)
  {
    const RefinedMotion refined = refinedMotion(source_,
                                                target_,
                                                inliers_,
                                                T_target_source_,
                                                settings_.model,
                                                settings_.refines);
    tellRefinement(refined);
    tellResiduals(refined.T_target_source);
    const PlanarPose pose = planarPartOf(refined.T_target_source);
    const EgomotionEstimate estimate{
        refined.T_target_source,
        {pose.x, pose.z, pose.theta},
        covarianceOf(refined.equations, refined.scatter, settings_.model)};
    if (auto failure = failureOfMotion(estimate, report_.contradicted, settings_))
      return failure;
    solution.estimate = estimate;
    return std::nullopt;
  }

private:
  void
  tellRefinement(const RefinedMotion& refined)
  {
    report_.is_refined = refined.is_refined;
    report_.surface_pairs = refined.surface_pairs;
    report_.surface_before = refined.surface_before;
    report_.surface_after = refined.surface_after;
    report_.contradicted = contradictedShare(source_, target_, refined.T_target_source);
  }

  void
  tellResiduals(const Eigen::Isometry3d& T_target_source)
  {
    double squares = 0, squared = 0;
    for (const FeaturePair& pair : inliers_) {
      squares += (T_target_source * pair.source - pair.target).squaredNorm();
      squared += squaredDistance(pair, T_target_source);
    }
    const auto count = static_cast<double>(inliers_.size());
    report_.feature_residual = std::sqrt(squares / count);
    report_.feature_chi = std::sqrt(squared / (3 * count));
  }

  const EgomotionView& source_;
  const EgomotionView& target_;
  const EgomotionSettings& settings_;
  EgomotionReport& report_;
  MotionFitter fitter_;
  std::vector<FeaturePair> alike_, consistent_, inliers_;
  Eigen::Isometry3d T_target_source_ = Eigen::Isometry3d::Identity();
};

void
remarkOnSigmas(const EgomotionView& view,
               const std::string& name,
               EgomotionReport& report)
{
  if (view.unknown_sigmas > 0)
    report.remarks.push_back(name + " has no sigma at " +
                             std::to_string(view.unknown_sigmas) + " of " +
                             std::to_string(view.points) + " points: estimated there");
}

std::optional<EgomotionFailure>
run(const EgomotionView& source,
    const EgomotionView& target,
    const EgomotionSettings& settings,
    const Progress& progress,
    EgomotionReport& report,
    EgomotionSolution& solution)
{
  for (const auto& failure :
       {failureOfView(target, "the target", settings.paper ? 1 : min_features),
        failureOfView(source, "the source", settings.paper ? 1 : min_features)})
    if (failure)
      return failure;
  StepTimer timer(report);
  EgomotionSteps chain(source, target, settings, report);
  if (const auto failure = chain.match(alikePairs(source, target, settings), solution))
    return failure;
  timer.finish("match");
  progress.tell(0.6, "fit");
  if (const auto failure = chain.leaveOut())
    return failure;
  if (settings.paper) {
    const auto failure = chain.fitOnce(solution);
    timer.finish("fit");
    progress.tell(1.0, "fit");
    return failure;
  }
  if (const auto failure = chain.fit(solution))
    return failure;
  timer.finish("fit");
  progress.tell(0.7, "refine");
  const auto failure = chain.refine(solution);
  timer.finish("refine");
  progress.tell(1.0, "refine");
  return failure;
}

std::optional<EgomotionFailure>
runWithPairs(EgomotionSteps& chain,
             const std::vector<FeaturePair>& pairs,
             EgomotionSolution& solution)
{
  if (const auto failure = chain.match(pairs, solution))
    return failure;
  if (const auto failure = chain.leaveOut())
    return failure;
  if (const auto failure = chain.fit(solution))
    return failure;
  return chain.refine(solution);
}

void
tellFailure(const std::optional<EgomotionFailure>& failure, EgomotionReport& report)
{
  report.outcome = failure ? failure->outcome : EgomotionOutcome::Estimated;
  if (failure)
    report.reason = failure->reason;
}

} // namespace

PatchShifts
shiftsOf(const EgomotionSettings& settings)
{
  const PatchShifts of_paper{1, 1};
  return settings.shifts.value_or(settings.paper ? of_paper : PatchShifts{});
}

EgomotionSettings
inMode(EgomotionSettings settings)
{
  settings.patches.ring_shifts = shiftsOf(settings).rings;
  settings.patches.sector_shifts = shiftsOf(settings).sectors;
  if (!settings.paper)
    return settings;
  constexpr double max_distortion = 1.15; // left open by the paper
  settings.solver = MotionSolver::ConjugateGradient;
  settings.refines = false;
  settings.keypoints.maximum = std::numeric_limits<std::size_t>::max();
  settings.worst_out.paper = true;
  settings.worst_out.max_distortion = max_distortion;
  return settings;
}

EgomotionSolution
estimateEgomotion(const EgomotionView& source,
                  const EgomotionView& target,
                  const EgomotionSettings& settings,
                  const Progress& progress,
                  EgomotionReport& report)
{
  EgomotionSolution solution;
  report.is_paper = settings.paper;
  report.source_points = source.points;
  report.target_points = target.points;
  report.source_keypoints = source.keypoints();
  report.target_keypoints = target.keypoints();
  remarkOnSigmas(source, "the source", report);
  remarkOnSigmas(target, "the target", report);
  const std::optional<EgomotionFailure> failure =
      run(source, target, settings, progress, report, solution);
  tellFailure(failure, report);
  return solution;
}

EgomotionSolution
estimateFromPairs(const EgomotionView& source,
                  const EgomotionView& target,
                  const std::vector<FeaturePair>& pairs,
                  const EgomotionSettings& settings,
                  EgomotionReport& report)
{
  EgomotionSolution solution;
  EgomotionSteps chain(source, target, settings, report);
  tellFailure(runWithPairs(chain, pairs, solution), report);
  return solution;
}

} // namespace pcl::acmap
