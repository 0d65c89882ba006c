#pragma once

#include "labeling/sight.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::acmap::labeling {

/** Normal equations of the plane z = a u + b v + c in a patch's frame. */
struct FitSums {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();

  FitSums&
  operator+=(const FitSums& other)
  {
    matrix += other.matrix;
    right += other.right;
    return *this;
  }

  /** Adds the distance of a point from the plane, at the intersection of its ray with
   * the plane. At the point itself, the errors of distance and position would be
   * correlated, and the plane would be tilted.
   * \param[in] weight inverse variance of the distance */
  [[gnu::always_inline]] void
  add(const Crossing& crossing, const PlanePatch& patch, double weight)
  {
    const Eigen::Vector3d from_center = crossing.foot - patch.center;
    const Eigen::Vector3d terms(
        from_center.dot(patch.axis_u), from_center.dot(patch.axis_v), 1.0);
    matrix += weight * terms * terms.transpose();
    right += weight * crossing.off * terms;
  }
};

/** Transforms the sums to another frame of the same plane. */
FitSums
movedSums(const FitSums& sums, const PlanePatch& from, const PlanePatch& to);

/** Are the standard deviations of both slopes at most \a maximum, in radians? Not if the
 * points are on one line. */
bool
knowsTilt(const FitSums& sums, double maximum);

/** Sets centre and axes of a patch from the distribution of its points; axis_u is along
 * the largest variance.
 * \param[in] sums of at least one point */
void
setFrame(const FitSums& sums, PlanePatch& patch);

/** Moves the plane to the fit.
 * \return the solution: slopes and offset; zero if the system cannot be solved */
Eigen::Vector3d
moveToFit(const FitSums& sums, PlanePatch& patch);

/** Covariance of the fit, estimated from the variation of the residuals of clusters:
 * noise that is shared within a cluster does not average out.
 * \param[in] guess_weight inverse variance of the guessed slopes that are included in
 * the sums but not in the clusters, 0 for none
 * \param[in] solution the result of \ref moveToFit
 * \return NaN if there are too few clusters for an estimate, or the result is not
 * finite */
Eigen::Matrix3d
clusteredCovariance(const FitSums& sums,
                    double guess_weight,
                    const Eigen::Vector3d& solution,
                    const LargeVector<FitSums>& clusters);

} // namespace pcl::acmap::labeling
