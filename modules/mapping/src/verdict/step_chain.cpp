#include "step_chain.h"

#include "../odometry_sigmas.h"

#include <pcl/core/impl/quantile.h>

#include <Eigen/LU>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

constexpr double step_doubt = 4;    ///< factor of the covariance of matches
constexpr double skip_doubt = 8;    ///< they share scans with the steps
constexpr double good = 0.7;        ///< quality
constexpr double clear_merit = 180; ///< raw units
constexpr double clear_gain = 64;   ///< raw units, over the odometry's step
constexpr double slip_sigmas = 6;
constexpr double sigmas_of_median = 1.4826;
constexpr double chi_square_90 = 6.25;   ///< of three degrees of freedom
constexpr std::size_t min_measured = 10; ///< steps that tell a noise

struct Step {
  PlanarPose odometry;   ///< as it was given
  Eigen::Vector3d sigma; ///< x, z, theta, as assumed
  ScanMatch match;
  double odometry_merit = 0;  ///< L at the odometry's step
  Eigen::Matrix3d covariance; ///< of the match
  bool slips = false;
};

/** d (a (+) b) / d b, and / d a. */
Eigen::Matrix3d
partOfSecond(const PlanarPose& a)
{
  Eigen::Matrix3d part = Eigen::Matrix3d::Identity();
  part.topLeftCorner<2, 2>() = PlanarMotion(a).rotation();
  return part;
}

Eigen::Matrix3d
partOfFirst(const PlanarPose& a, const PlanarPose& b)
{
  Eigen::Matrix3d part = Eigen::Matrix3d::Identity();
  part.block<2, 1>(0, 2) = PlanarMotion(a).turn(b.x, b.z);
  return part;
}

std::vector<Step>
matchedSteps(const std::vector<BeamScan>& scans,
             const std::vector<PlanarPose>& odometry,
             const OdometryNoise& assumed)
{
  std::vector<Step> steps(scans.size() - 1);
  oneapi::tbb::parallel_for(std::size_t{0}, steps.size(), [&](std::size_t t) {
    Step& step = steps[t];
    step.odometry = relative(odometry[t], odometry[t + 1]);
    const double length =
        lengthSigma(assumed, std::hypot(step.odometry.x, step.odometry.z));
    step.sigma = {length, length, turnSigma(assumed, std::abs(step.odometry.theta))};
    const StepMatch match = matchStep(scans[t], scans[t + 1], step.odometry);
    step.match = match.best;
    step.odometry_merit = match.odometry_merit;
  });
  return steps;
}

/** A match over two steps. */
struct Skip {
  ScanMatch match;
  double distance = -1; ///< squared, of Mahalanobis, from both steps; below 0: not good
};

std::vector<Skip>
matchedSkips(const std::vector<BeamScan>& scans, const std::vector<Step>& steps)
{
  std::vector<Skip> skips(steps.size() - 1);
  oneapi::tbb::parallel_for(std::size_t{0}, skips.size(), [&](std::size_t t) {
    const ScanMatch &first = steps[t].match, &second = steps[t + 1].match;
    const PlanarPose both = composed(first.T_i_j, second.T_i_j);
    ScanMatch& direct = skips[t].match = matchScans(scans[t], scans[t + 2], both);
    if (!(std::min(
              {first.score.quality(), second.score.quality(), direct.score.quality()}) >
          good))
      return;
    const Eigen::Matrix3d a = partOfFirst(first.T_i_j, second.T_i_j);
    const Eigen::Matrix3d b = partOfSecond(first.T_i_j);
    const Eigen::Matrix3d covariance =
        a * covarianceOf(first, step_doubt) * a.transpose() +
        b * covarianceOf(second, step_doubt) * b.transpose() +
        covarianceOf(direct, step_doubt);
    const Eigen::Vector3d off = differenceOf(both, direct.T_i_j);
    skips[t].distance = off.dot(covariance.inverse() * off);
  });
  return skips;
}

/** The matches over two steps that agree with both and tell all directions: where scans can
 * slide along a corridor, the same error would count twice. */
std::vector<PoseLink>
linksOf(const std::vector<Skip>& skips, double inflation)
{
  constexpr double determined = 0.03; // metres
  std::vector<PoseLink> links;
  for (std::size_t t = 0; t < skips.size(); ++t) {
    const Eigen::Matrix3d covariance =
        covarianceOf(skips[t].match, step_doubt * inflation);
    if (skips[t].distance >= 0 && skips[t].distance < chi_square_90 * inflation &&
        covariance.topLeftCorner<2, 2>().trace() < determined * determined)
      links.push_back({t,
                       t + 2,
                       skips[t].match.T_i_j,
                       covarianceOf(skips[t].match, skip_doubt * inflation)});
  }
  return links;
}

/** Factor of the covariances of the matches. */
double
inflationOf(const std::vector<Skip>& skips)
{
  std::vector<double> distances;
  for (const Skip& skip : skips)
    if (skip.distance >= 0)
      distances.push_back(skip.distance);
  return distances.empty()
             ? 1
             : std::clamp(2 * quantileOf(distances, 0.9) / chi_square_90, 1.0, 25.0);
}

template <typename Noise>
auto&
componentOf(Noise& noise, int axis)
{
  return axis == 0 ? noise.across : axis == 1 ? noise.ahead : noise.turn;
}

/** Bias and scale of the odometry in units of its assumed sigmas. */
void
measureNoise(const std::vector<Step>& steps, MeasuredOdometry& noise)
{
  constexpr double observed[] = {0.03, 0.03, 0.01}; // metres, metres, radians
  for (const int axis : {0, 1, 2}) {
    std::vector<double> errors;
    for (const Step& step : steps)
      if (std::sqrt(step.covariance(axis, axis)) < observed[axis])
        errors.push_back(differenceOf(step.odometry, step.match.T_i_j)[axis] /
                         step.sigma[axis]);
    MeasuredOdometry::Component& told = componentOf(noise, axis);
    told.steps = errors.size();
    if (errors.size() < min_measured)
      continue;
    told.bias = medianOf(errors);
    for (double& error : errors)
      error = std::abs(error - told.bias);
    told.scale = sigmas_of_median * medianOf(errors);
  }
}

/** Steps in which the wheels slipped, as scans show that see them well. */
void
findSlips(std::vector<Step>& steps, MeasuredOdometry& noise)
{
  for (Step& step : steps) {
    const PairScore& score = step.match.score;
    if (!(score.quality() > good && score.merit > clear_merit &&
          score.merit - step.odometry_merit > clear_gain))
      continue;
    const Eigen::Vector3d off = differenceOf(step.odometry, step.match.T_i_j);
    for (const int axis : {0, 1, 2}) {
      const MeasuredOdometry::Component& told = componentOf(noise, axis);
      const double sigma =
          std::hypot(1.5 * std::max(0.1, told.scale) * step.sigma[axis],
                     std::sqrt(step.covariance(axis, axis)));
      step.slips |=
          std::abs(off[axis] - told.bias * step.sigma[axis]) > slip_sigmas * sigma;
    }
    noise.slips += step.slips;
  }
}

/** The odometry's step without its bias, and its variances. */
PlanarPose
unbiased(const Step& step, const MeasuredOdometry& noise, Eigen::Vector3d& variances)
{
  constexpr double usual_slip = 0.7, least_slip = 0.05, slip_turn = 0.2;
  constexpr double slipped = 400;
  const double share = noise.slips > 1 ? static_cast<double>(noise.slips) /
                                             static_cast<double>(noise.steps)
                                       : 0.0;
  const double length = std::hypot(step.odometry.x, step.odometry.z);
  Eigen::Vector3d bias;
  for (const int axis : {0, 1, 2}) {
    const MeasuredOdometry::Component& told = componentOf(noise, axis);
    bias[axis] = told.bias * step.sigma[axis];
    variances[axis] = std::pow(1.5 * std::max(0.1, told.scale) * step.sigma[axis], 2) +
                      std::pow(0.5 * bias[axis], 2);
  }
  variances[0] += share * (std::pow(usual_slip * length, 2) + std::pow(least_slip, 2));
  variances[1] += share * (std::pow(usual_slip * length, 2) + std::pow(least_slip, 2));
  variances[2] += share * std::pow(slip_turn, 2);
  if (step.slips)
    variances *= slipped;
  return {step.odometry.x - bias[0],
          step.odometry.z - bias[1],
          step.odometry.theta - bias[2]};
}

PoseLink
fused(std::size_t t, const Step& step, const MeasuredOdometry& noise)
{
  Eigen::Vector3d variances;
  const PlanarPose odometry = unbiased(step, noise, variances);
  const Eigen::Matrix3d match = step.covariance.inverse();
  Eigen::Matrix3d both = match;
  both.diagonal() += variances.cwiseInverse();
  const Eigen::Matrix3d covariance = both.inverse();
  const Eigen::Vector3d change =
      covariance * match * differenceOf(step.match.T_i_j, odometry);
  return {t,
          t + 1,
          {odometry.x + change[0], odometry.z + change[1], odometry.theta + change[2]},
          covariance};
}

} // namespace

StepChain
chainOfSteps(const std::vector<BeamScan>& scans,
             const std::vector<PlanarPose>& odometry,
             const OdometryNoise& assumed,
             MeasuredOdometry& noise)
{
  StepChain chain;
  std::vector<Step> steps = matchedSteps(scans, odometry, assumed);
  const std::vector<Skip> skips = matchedSkips(scans, steps);
  chain.inflation = inflationOf(skips);
  for (Step& step : steps)
    step.covariance = covarianceOf(step.match, step_doubt * chain.inflation);
  noise.steps = steps.size();
  measureNoise(steps, noise);
  findSlips(steps, noise);
  for (std::size_t t = 0; t < steps.size(); ++t)
    chain.links.push_back(fused(t, steps[t], noise));
  chain.skips = linksOf(skips, chain.inflation);
  return chain;
}

} // namespace pcl::acmap
