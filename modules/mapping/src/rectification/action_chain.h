#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A path as a chain of actions, each known with the odometry's noise.
 *
 * Its variables are the whitened residuals u_t = C_t^{-1/2} (a_t - a_ego,t), three for
 * each action; u = 0 is the path as odometry has it. One more turns the whole map about
 * the first pose: bins favour walls along their axes, and would bend the path for it. */
class ActionChain {
public:
  ActionChain(const std::vector<PlanarPose>& odometry, const OdometryNoise& noise);

  Eigen::Index
  variables() const
  {
    return residuals() + 1;
  }

  /** \brief Those of the actions, which come first; the prior is on them alone. */
  Eigen::Index
  residuals() const
  {
    return 3 * static_cast<Eigen::Index>(actions_.size());
  }

  /** \brief p_t = p_{t-1} (+) a_t, in the turned map. */
  std::vector<PlanarPose>
  poses(const Eigen::VectorXd& u) const;

  /** \brief The same where the first pose stays as it is. */
  std::vector<PlanarPose>
  path(Eigen::VectorXd u) const;

  /** \brief From the derivatives by each pose those by each variable: an action moves all
   * poses after it, so its are sums over a suffix. */
  Eigen::VectorXd
  gradient(const std::vector<PlanarPose>& poses,
           const std::vector<Eigen::Vector3d>& by_pose) const;

  /** \brief The chain of poses [first, last), beginning at the origin. */
  ActionChain
  part(std::size_t first, std::size_t last) const;

  /** \brief The same with all sigmas times \a factor. */
  ActionChain
  widened(double factor) const;

private:
  PlanarPose first_;
  std::vector<PlanarAction> actions_;
  std::vector<Eigen::Vector3d> sigmas_;
};

} // namespace pcl::acmap
