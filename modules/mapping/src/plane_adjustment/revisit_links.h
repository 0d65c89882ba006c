#pragma once

#include "measured_motion.h"

#include <pcl/mapping/impl/plane_adjustment_kernel.h>

#include <cstddef>
#include <vector>

namespace pcl::acmap {

/** \brief Relative poses of views that have seen the same place. Each is either used,
 * as an action of the odometry is, or dropped because other evidence contradicts it. */
class RevisitLinks {
public:
  explicit RevisitLinks(const std::vector<RevisitConstraint>& revisits);

  /** \brief Number of those that are used. */
  std::size_t
  used() const
  {
    return links_.size();
  }

  /** \brief Adds the pairs of rows of those that are used; pose i is row i - 1. */
  void
  addPairs(std::vector<PoseSystem::Pair>& pairs) const;

  /** \brief Sum of the squared residuals in standard deviations. */
  double
  cost(const Poses& poses) const;

  /** \brief Adds to the normal equations; pose i is row i - 1.
   * \param[in,out] gradient one per row */
  void
  linearize(const Poses& poses,
            PoseSystem& system,
            std::vector<Vector6>& gradient) const;

  /** \brief Drops those that lead farther than the uncertainty of the poses permits.
   * \param[in] inverse of the equations of the poses, with the pairs of all links in
   * its pattern */
  void
  dropImplausible(const Poses& poses, const PoseSystem& inverse);

  /** \brief Drops those that poses adjusted to all evidence contradict: the worst tenth
   * at once, since a wrong one pulls right ones away.
   * \return false if there is none */
  bool
  dropContradicted(const Poses& poses);

private:
  struct Link {
    MeasuredMotion motion;
    Matrix6 covariance, information;
  };

  std::vector<Link> links_;
};

} // namespace pcl::acmap
