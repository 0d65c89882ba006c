#include "scan_matching.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {
namespace {

constexpr int matching_iterations = 12;
constexpr double last_reach = 0.25;                    ///< metres
constexpr double first_scale = 0.3, last_scale = 0.06; ///< metres, of the weights
constexpr double facing_alike = 0.8;   ///< cosine of two normals, 37 degrees
constexpr double min_rms = 0.01;       ///< metres
constexpr double feigned_share = 0.01; ///< share of the trace
constexpr double good_share = 0.7;     ///< quality that needs no other start
constexpr double near_merit = 32, merit_scale = 8; ///< raw units

/** Nearest echo on a line of a scan within reach. */
const BeamScan::Echo*
nearestLine(const BeamScan& scan,
            const Eigen::Vector2d& place,
            const Eigen::Vector2d& normal,
            double reach)
{
  const double range = place.norm();
  const double at = scan.directionOf(place);
  const double half =
      std::asin(std::min(1.0, reach / std::max(range, reach))) / scan.step;
  const int last = static_cast<int>(scan.ranges.size()) - 1;
  const int from = std::max(0, static_cast<int>(std::ceil(at - half)));
  const int to = std::min(last, static_cast<int>(std::floor(at + half)));
  const BeamScan::Echo* best = nullptr;
  double nearest = reach * reach;
  for (int beam = from; beam <= to; ++beam) {
    if (scan.echo_of[beam] < 0)
      continue;
    const BeamScan::Echo& echo = scan.echoes[scan.echo_of[beam]];
    const double distance = (echo.place - place).squaredNorm();
    if (distance < nearest && echo.is_on_line &&
        echo.normal.dot(normal) > facing_alike) {
      nearest = distance;
      best = &echo;
    }
  }
  return best;
}

/** Normal equations of one iteration. */
struct Equations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< of residuals in metres
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double squares = 0, weights = 0;

  double
  rms() const
  {
    return std::max(min_rms, weights > 0 ? std::sqrt(squares / weights) : 0.0);
  }
};

Equations
equationsAt(const BeamScan& i,
            const BeamScan& j,
            const PlanarPose& T_i_j,
            double reach,
            double scale)
{
  const PlanarMotion motion(T_i_j);
  const Eigen::Matrix2d rotation = motion.rotation();
  Equations sum;
  for (const BeamScan::Echo& echo : j.echoes) {
    if (!echo.is_on_line)
      continue;
    const Eigen::Vector2d place = motion.place(echo.place.x(), echo.place.y());
    const BeamScan::Echo* line = nearestLine(i, place, rotation * echo.normal, reach);
    if (!line)
      continue;
    const double residual = line->normal.dot(place - line->place);
    const Eigen::Vector3d row(
        line->normal.x(),
        line->normal.y(),
        line->normal.dot(motion.turn(echo.place.x(), echo.place.y())));
    const double weight = std::pow(1 + std::pow(residual / scale, 2), -2);
    sum.information += weight * row * row.transpose();
    sum.gradient += weight * residual * row;
    sum.squares += weight * residual * residual;
    sum.weights += weight;
  }
  return sum;
}

/** Takes away what noise of the normals feigns in the directions that are seen least: along
 * a corridor, or around the middle of a round room. */
Eigen::Matrix3d
withoutFeigned(const Eigen::Matrix3d& information)
{
  const double trace = information.topLeftCorner<2, 2>().trace();
  if (!(trace > 0 && information(2, 2) > 0))
    return Eigen::Matrix3d::Zero();
  // in metres at the usual distance of the walls, as far as turns are concerned
  const Eigen::Vector3d unit(1, 1, std::sqrt(trace / 2 / information(2, 2)));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      unit.asDiagonal() * information * unit.asDiagonal());
  Eigen::Vector3d kept;
  for (const int k : {0, 1, 2})
    kept[k] = std::max(0.0, solver.eigenvalues()[k] - feigned_share * trace);
  const Eigen::Matrix3d less =
      solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
  return unit.cwiseInverse().asDiagonal() * less * unit.cwiseInverse().asDiagonal();
}

ScanMatch
matchAt(const BeamScan& i, const BeamScan& j, const PlanarPose& T_i_j)
{
  ScanMatch match;
  match.T_i_j = T_i_j;
  match.score = scoreOf(i, j, T_i_j);
  const Equations sum = equationsAt(i, j, T_i_j, last_reach, last_scale);
  match.information = withoutFeigned(sum.information / std::pow(sum.rms(), 2));
  return match;
}

/** The prior's information: x, z, theta. */
Eigen::Vector3d
informationOf(const MatchPrior& prior)
{
  return Eigen::Vector3d(prior.length, prior.length, prior.turn)
      .cwiseAbs2()
      .cwiseInverse();
}

} // namespace

Eigen::Vector3d
differenceOf(const PlanarPose& a, const PlanarPose& b)
{
  return {a.x - b.x, a.z - b.z, std::remainder(a.theta - b.theta, 2 * M_PI)};
}

ScanMatch
matchScans(const BeamScan& i,
           const BeamScan& j,
           const PlanarPose& start,
           const MatchPrior& prior)
{
  PlanarPose pose = start;
  const Eigen::Vector3d weak = informationOf(prior);
  for (int k = 0; k < matching_iterations; ++k) {
    const double part = static_cast<double>(k) / (matching_iterations - 1);
    const double reach =
        std::min(prior.reach, prior.reach + part * (last_reach - prior.reach));
    const Equations sum =
        equationsAt(i, j, pose, reach, first_scale + part * (last_scale - first_scale));
    const double variance = std::pow(sum.rms(), 2);
    Eigen::Matrix3d matrix = sum.information / variance;
    matrix.diagonal() += weak;
    const Eigen::Vector3d change = matrix.ldlt().solve(
        -sum.gradient / variance - weak.cwiseProduct(differenceOf(pose, start)));
    pose = {pose.x + change[0], pose.z + change[1], pose.theta + change[2]};
  }
  return matchAt(i, j, pose);
}

StepMatch
matchStep(const BeamScan& i, const BeamScan& j, const PlanarPose& odometry)
{
  std::vector<ScanMatch> found{matchScans(i, j, odometry), matchAt(i, j, odometry)};
  const double odometry_merit = found.back().score.merit;
  const Eigen::Vector3d change = differenceOf(found.front().T_i_j, odometry);
  const double length = std::hypot(odometry.x, odometry.z);
  if (found.front().score.quality() < good_share ||
      change.head<2>().norm() > 0.1 + 0.1 * length) {
    for (const double turn : {-0.35, -0.17, 0.17, 0.35})
      found.push_back(
          matchScans(i, j, {odometry.x, odometry.z, odometry.theta + turn}));
    for (const double ahead : {-0.5, -0.25, 0.25, 0.5})
      found.push_back(
          matchScans(i, j, {odometry.x, odometry.z + ahead, odometry.theta}));
  }
  const auto best =
      std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.score.merit < b.score.merit;
      });
  ScanMatch match = *best;
  double weights = 0;
  for (const ScanMatch& other : found) {
    const double behind = match.score.merit - other.score.merit;
    if (behind > near_merit)
      continue;
    const Eigen::Vector3d off = differenceOf(other.T_i_j, match.T_i_j);
    const double weight = std::exp(-behind / merit_scale);
    match.spread += weight * off * off.transpose();
    weights += weight;
  }
  match.spread /= weights;
  return {match, odometry_merit};
}

Eigen::Matrix3d
covarianceOf(const ScanMatch& match, double doubt)
{
  const auto within = [](double value) { return std::clamp(value, 0.0, 1.0); };
  const PairScore& score = match.score;
  const double trust = std::pow(within((score.quality() - 0.5) / 0.35), 2) *
                       within(score.agree / 60) *
                       within((score.merit / 180 - 0.3) / 0.7);
  Eigen::Matrix3d information = trust / doubt * match.information;
  information.diagonal() += Eigen::Vector3d(0.5, 0.5, 0.3).cwiseAbs2().cwiseInverse();
  Eigen::Matrix3d covariance = information.inverse() + match.spread;
  covariance.diagonal() += Eigen::Vector3d(0.003, 0.003, 0.001).cwiseAbs2();
  return covariance;
}

} // namespace pcl::acmap
