#pragma once

#include <pcl/core/planar_pose.h>
#include <pcl/mapping/entropy_rectification_types.h>

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap {

/** \brief A path as a chain of actions, each with the noise of the odometry.
 *
 * The variables are the whitened residuals u_t = C_t^{-1/2} (a_t - a_ego,t), three per
 * action; u = 0 is the path of the odometry. One more variable rotates the whole map
 * about the first pose: bins favour walls along their axes, so without it the path
 * would be bent to align the walls. */
class ActionChain {
public:
  ActionChain(const std::vector<PlanarPose>& odometry, const OdometryNoise& noise);

  Eigen::Index
  variables() const
  {
    return residuals() + 1;
  }

  /** \brief Number of the residuals of the actions, which are the first variables. */
  Eigen::Index
  residuals() const
  {
    return 3 * static_cast<Eigen::Index>(actions_.size());
  }

  /** \brief Energy of the residuals: minus their log-likelihood, with a constant left
   * out. They are independent, unless turns have an error in common.
   * \param[out] gradient by each variable; may be null */
  double
  prior(const Eigen::VectorXd& u, Eigen::VectorXd* gradient = nullptr) const;

  /** \brief p_t = p_{t-1} (+) a_t, in the rotated map. */
  std::vector<PlanarPose>
  poses(const Eigen::VectorXd& u) const;

  /** \brief Same, without the rotation of the map: the first pose is unchanged. */
  std::vector<PlanarPose>
  path(Eigen::VectorXd u) const;

  /** \brief Computes the derivatives by each variable from those by each pose: an
   * action moves all poses after it, so its derivatives are sums over a suffix. */
  Eigen::VectorXd
  gradient(const std::vector<PlanarPose>& poses,
           const std::vector<Eigen::Vector3d>& by_pose) const;

  /** \brief The chain of poses [first, last), starting at the origin. */
  ActionChain
  part(std::size_t first, std::size_t last) const;

  /** \brief Same, with all sigmas multiplied by \a factor. */
  ActionChain
  widened(double factor) const;

  /** \brief Same, where the turns of all actions have an error in common, too, of half
   * their sigma: a path that bends evenly is not the less probable the longer it is. */
  ActionChain
  withCommonTurn() const;

private:
  PlanarPose first_;
  std::vector<PlanarAction> actions_;
  std::vector<Eigen::Vector3d> sigmas_;
  double common_variance_ = 0; ///< of the turns' common error, in their variances
};

} // namespace pcl::acmap
