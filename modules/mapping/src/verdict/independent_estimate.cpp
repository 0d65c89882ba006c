#include "independent_estimate.h"

#include <pcl/core/exceptions.h>
#include <pcl/core/impl/quantile.h>
#include <pcl/core/impl/size_text.h>
#include <pcl/core/trajectory_error.h>

#include <Eigen/LU>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

using Path = std::vector<PlanarPose>;

constexpr double wide = 2;           ///< factor of the draws' distance from their mean
constexpr double pose_length = 0.03; ///< metres, tolerance of a pose
constexpr double pose_turn = 0.008;  ///< radians
constexpr double wrong_sigmas = 9;   ///< of a window that is named
constexpr std::size_t named = 3;     ///< windows

/** \brief Window of a trajectory and what the estimate says of it. */
struct Window {
  std::size_t first = 0, last = 0;
  PlanarPose mean = {};
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  /** \brief Squared distance of a trajectory in this window, of Mahalanobis. */
  double
  distance(const Path& poses) const
  {
    const Eigen::Vector3d off = differenceOf(relative(poses[first], poses[last]), mean);
    return off.dot(information * off);
  }
};

/** Covariance of the relative pose of two poses that may be a little wrong. */
Eigen::Matrix3d
toleranceOf(const PlanarPose& between)
{
  const Eigen::Vector3d each(pose_length, pose_length, pose_turn);
  Eigen::Matrix3d tolerance = 2 * each.cwiseAbs2().asDiagonal().toDenseMatrix();
  tolerance(2, 2) /= 2; // the turn at the beginning has a lever
  const Eigen::Vector3d lever(-between.z, between.x, -1);
  return tolerance + pose_turn * pose_turn * lever * lever.transpose();
}

/** Windows of 1, 2, 4, .. steps, each half of their length. */
std::vector<Window>
windowsOf(const PoseDraws& drawn)
{
  std::vector<Window> windows;
  const std::size_t poses = drawn.mean.size();
  for (std::size_t length = 1; length < poses; length *= 2)
    for (std::size_t first = 0; first + length < poses;
         first += std::max<std::size_t>(1, length / 2))
      windows.push_back({first, first + length});
  oneapi::tbb::parallel_for(std::size_t{0}, windows.size(), [&](std::size_t k) {
    Window& window = windows[k];
    window.mean = relative(drawn.mean[window.first], drawn.mean[window.last]);
    window.information =
        (drawn.covarianceBetween(window.first, window.last) + toleranceOf(window.mean))
            .inverse();
  });
  return windows;
}

/** Errors of a trajectory if each draw were the truth, metres. */
std::vector<double>
errorsOf(const Path& poses, const PoseDraws& drawn)
{
  std::vector<double> errors(drawn.draws.size());
  oneapi::tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t draw) {
    errors[draw] = absoluteTrajectoryError(poses, drawn.widened(draw, wide)).aligned;
  });
  return errors;
}

double
shareWorse(const std::vector<double>& errors, const std::vector<double>& given)
{
  std::size_t worse = 0;
  for (std::size_t draw = 0; draw < errors.size(); ++draw)
    worse += errors[draw] > 1.05 * given[draw] + 0.04;
  return static_cast<double>(worse) / static_cast<double>(errors.size());
}

double
upperOf(std::vector<double> errors)
{
  return quantileOf(errors, 0.95);
}

double
lowerOf(std::vector<double> errors)
{
  return quantileOf(errors, 0.05);
}

/** The worst windows that do not overlap. */
std::vector<ContradictedWindow>
worstOf(std::vector<ContradictedWindow> windows)
{
  std::stable_sort(windows.begin(), windows.end(), [](const auto& a, const auto& b) {
    return a.sigmas > b.sigmas;
  });
  std::vector<ContradictedWindow> worst;
  for (const ContradictedWindow& one : windows)
    if (worst.size() < named &&
        std::all_of(worst.begin(), worst.end(), [&](const ContradictedWindow& other) {
          return one.last <= other.first || other.last <= one.first;
        }))
      worst.push_back(one);
  return worst;
}

/** Judges a trajectory alone: its largest window and its error decide. */
VerdictOutcome
outcomeAlone(double largest, double e95)
{
  constexpr double contradicted = 12, agreeing = 6; // sigmas
  constexpr double tolerated = 0.5;                 // metres
  if (largest > contradicted)
    return VerdictOutcome::Contradicted;
  return e95 < tolerated && largest < agreeing ? VerdictOutcome::Consistent
                                               : VerdictOutcome::Undetermined;
}

/** \param[in] less how much the poses contradict the estimate more than the given ones, in
 * sigmas
 * \param[in] is_smaller is their error smaller, whatever single windows say? */
VerdictOutcome
outcomeOf(const MapVerdictReport& report, double more, bool is_smaller)
{
  constexpr double unlikely = 0.05, much = 6, most = 9; // probability, sigmas, sigmas
  if (report.probability_worse < unlikely &&
      report.probability_worse_without_revisits < 1 - unlikely &&
      (more < much || is_smaller))
    return VerdictOutcome::Consistent;
  return report.probability_worse > 1 - unlikely || more > most
             ? VerdictOutcome::Contradicted
             : VerdictOutcome::Undetermined;
}

void
tellWindows(MapVerdictReport& report)
{
  for (const ContradictedWindow& window : report.windows)
    report.reasons.push_back(
        "observations " + std::to_string(window.first) + " to " +
        std::to_string(window.last) + " lie " + shortNumber(window.sigmas) +
        " standard deviations off what neighbouring ones and the odometry give");
}

void
tellReasons(double more, MapVerdictReport& report)
{
  std::vector<std::string>& reasons = report.reasons;
  reasons.push_back(
      "the error is at most " + shortNumber(report.e95) +
      " m (95 %), that of the given poses at most " + shortNumber(report.e95_given) +
      " m; it is larger with probability " + shortNumber(report.probability_worse));
  if (more > 0)
    tellWindows(report);
  if (report.ambiguous_revisits > 0 && report.outcome != VerdictOutcome::Consistent)
    reasons.push_back("ambiguous: " + std::to_string(report.ambiguous_revisits) +
                      " places look like others, and nothing that was seen tells which "
                      "ones they are");
}

} // namespace

bool
areScans(const std::vector<LevelledPoints>& observations)
{
  return std::all_of(observations.begin(), observations.end(), isPlanarScan);
}

void
requirePoses(const std::vector<PlanarPose>& poses, std::size_t observations)
{
  if (poses.size() != observations)
    throw BadArgument("each observation needs one pose");
  for (const PlanarPose& pose : poses)
    if (!std::isfinite(pose.x) || !std::isfinite(pose.z) || !std::isfinite(pose.theta))
      throw BadArgument("the pose of an observation is not finite");
}

IndependentEstimate::IndependentEstimate(
    const std::vector<LevelledPoints>& observations,
    const std::vector<PlanarPose>& given,
    const OdometryNoise& assumed,
    std::uint64_t seed,
    const Progress& progress)
: given_(given)
{
  requirePoses(given, observations.size());
  std::vector<BeamScan> scans(observations.size());
  oneapi::tbb::parallel_for(std::size_t{0}, scans.size(), [&](std::size_t i) {
    scans[i] = beamScanOf(observations[i]);
  });
  progress.tell(0, "verdict");
  const StepChain chain = chainOfSteps(scans, given, assumed, odometry_);
  chain_ = drawPoses(chain, {}, seed);
  drawn_ = chain_;
  progress.tell(0, "verdict");
  revisits_ = findRevisits(scans, chain, seed, drawn_);
}

MapVerdictReport
IndependentEstimate::judge(const std::vector<PlanarPose>& poses) const
{
  requirePoses(poses, given_.size());
  MapVerdictReport report;
  report.observations = given_.size();
  report.odometry = odometry_;
  report.revisits = revisits_.used;
  report.ambiguous_revisits = revisits_.ambiguous;
  const std::vector<double> errors = errorsOf(poses, drawn_);
  const std::vector<double> given_errors = errorsOf(given_, drawn_);
  report.probability_worse = shareWorse(errors, given_errors);
  report.probability_worse_without_revisits =
      shareWorse(errorsOf(poses, chain_), errorsOf(given_, chain_));
  report.e95 = upperOf(errors);
  report.e95_given = upperOf(given_errors);
  double more = 0, largest_given = 0;
  for (const Window& window : windowsOf(drawn_)) {
    const double now = window.distance(poses), before = window.distance(given_);
    more = std::max(more, now - before);
    largest_given = std::max(largest_given, before);
    if (std::sqrt(now) > wrong_sigmas)
      report.windows.push_back({window.first, window.last, std::sqrt(now)});
  }
  more = std::sqrt(more);
  report.windows = worstOf(report.windows);
  report.outcome =
      outcomeOf(report, more, report.e95 < 0.8 * lowerOf(given_errors) - 0.03);
  report.given = outcomeAlone(std::sqrt(largest_given), report.e95_given);
  if (std::max(odometry_.across.steps, odometry_.ahead.steps) == 0) {
    report.outcome = report.given = VerdictOutcome::Undetermined;
    report.reasons.emplace_back(
        "neighbouring observations see no surface in common: only the odometry tells");
  }
  tellReasons(more, report);
  return report;
}

MapVerdictReport
IndependentEstimate::judgeGiven() const
{
  MapVerdictReport report = judge(given_);
  report.outcome = report.given;
  report.reasons = {"the error of the given poses is at most " +
                    shortNumber(report.e95_given) + " m (95 %)"};
  tellWindows(report);
  return report;
}

} // namespace pcl::acmap
