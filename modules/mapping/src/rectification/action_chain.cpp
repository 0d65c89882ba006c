#include "action_chain.h"

#include "../odometry_sigmas.h"

#include <cmath>

namespace pcl::acmap {
namespace {

constexpr double map_turn = 0.02; ///< radians; turn of the whole map for u = 1

} // namespace

ActionChain::ActionChain(const std::vector<PlanarPose>& odometry,
                         const OdometryNoise& noise)
: first_(odometry.front())
{
  for (std::size_t t = 1; t < odometry.size(); ++t) {
    const PlanarAction action = actionBetween(odometry[t - 1], odometry[t]);
    const double length = lengthSigma(noise, std::hypot(action.dx, action.dz));
    const double turn = turnSigma(noise, std::abs(action.dtheta));
    actions_.push_back(action);
    sigmas_.emplace_back(length, length, turn);
  }
}

double
ActionChain::prior(const Eigen::VectorXd& u, Eigen::VectorXd* gradient) const
{
  const auto actions = static_cast<Eigen::Index>(actions_.size());
  const auto turns = Eigen::seqN(2, actions, 3);
  const double share =
      common_variance_ / (1 + common_variance_ * static_cast<double>(actions));
  const double bias = share * u(turns).sum(); // the most likely common error
  if (gradient) {
    *gradient = u;
    (*gradient)(turns).array() -= bias;
    (*gradient)[residuals()] = 0;
  }
  return (u.head(residuals()).squaredNorm() - bias * u(turns).sum()) / 2;
}

std::vector<PlanarPose>
ActionChain::poses(const Eigen::VectorXd& u) const
{
  std::vector<PlanarPose> poses{first_};
  poses.front().theta += map_turn * u[residuals()];
  poses.reserve(actions_.size() + 1);
  for (std::size_t t = 0; t < actions_.size(); ++t) {
    const Eigen::Vector3d change =
        u.segment<3>(3 * static_cast<Eigen::Index>(t)).cwiseProduct(sigmas_[t]);
    PlanarAction action = actions_[t];
    action.dx += change[0];
    action.dz += change[1];
    action.dtheta += change[2];
    poses.push_back(moved(poses.back(), action));
    poses.back().theta = std::remainder(poses.back().theta, 2 * M_PI); // many turns
  }
  return poses;
}

std::vector<PlanarPose>
ActionChain::path(Eigen::VectorXd u) const
{
  u[residuals()] = 0;
  return poses(u);
}

Eigen::VectorXd
ActionChain::gradient(const std::vector<PlanarPose>& poses,
                      const std::vector<Eigen::Vector3d>& by_pose) const
{
  Eigen::VectorXd result(variables());
  double by_x = 0, by_z = 0, by_turn = 0; // of the suffix; its turn about the origin
  for (std::size_t t = actions_.size(); t > 0; --t) {
    const PlanarPose& pose = poses[t];
    by_x += by_pose[t][0];
    by_z += by_pose[t][1];
    by_turn += by_pose[t][2] + by_pose[t][0] * pose.z - by_pose[t][1] * pose.x;
    const double c = std::cos(poses[t - 1].theta);
    const double s = std::sin(poses[t - 1].theta);
    const Eigen::Vector3d by_action(c * by_x - s * by_z,
                                    s * by_x + c * by_z,
                                    by_turn - (by_x * pose.z - by_z * pose.x));
    result.segment<3>(3 * static_cast<Eigen::Index>(t - 1)) =
        by_action.cwiseProduct(sigmas_[t - 1]);
  }
  const PlanarPose& first = poses.front();
  result[residuals()] =
      map_turn * (by_turn - (by_x * first.z - by_z * first.x) + by_pose[0][2]);
  return result;
}

ActionChain
ActionChain::part(std::size_t first, std::size_t last) const
{
  const auto at = [](const auto& values, std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(i);
  };
  ActionChain chain(*this);
  chain.first_ = {};
  chain.actions_.assign(at(actions_, first), at(actions_, last - 1));
  chain.sigmas_.assign(at(sigmas_, first), at(sigmas_, last - 1));
  return chain;
}

ActionChain
ActionChain::widened(double factor) const
{
  ActionChain chain(*this);
  for (Eigen::Vector3d& sigma : chain.sigmas_)
    sigma *= factor;
  return chain;
}

ActionChain
ActionChain::withCommonTurn() const
{
  constexpr double sigma = 0.5;
  ActionChain chain(*this);
  chain.common_variance_ = sigma * sigma;
  return chain;
}

} // namespace pcl::acmap
