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

  /** Adds a point: its distance from the plane, at the place where its ray meets it. Taken
   * at the point itself, distance and place would be wrong together, and the plane tilted.
   * \param[in] weight 1 over the variance of the distance */
  void
  add(const Crossing& crossing, const PlanePatch& patch, double weight)
  {
    const Eigen::Vector3d from_center = crossing.foot - patch.center;
    const Eigen::Vector3d terms(
        from_center.dot(patch.axis_u), from_center.dot(patch.axis_v), 1.0);
    matrix += weight * terms * terms.transpose();
    right += weight * crossing.off * terms;
  }
};

/** The same sums in another frame of the same plane. */
FitSums
movedSums(const FitSums& sums, const PlanePatch& from, const PlanePatch& to);

/** Does the fit know both slopes to so many radians, one standard deviation? Not where its
 * points are on one line. */
bool
knowsTilt(const FitSums& sums, double most);

/** Middle and axes of a patch from where its points are; axis_u along the largest spread.
 * \param[in] sums of one point at least */
void
setFrame(const FitSums& sums, PlanePatch& patch);

/** Moves the plane to the fit.
 * \return what was solved for: slopes and offset; zero where nothing can be solved */
Eigen::Vector3d
moveToFit(const FitSums& sums, PlanePatch& patch);

/** Covariance of the fit from how the residuals of clusters vary: noise that points of a
 * cluster share does not average out.
 * \param[in] guess_weight of the guess of both slopes that the sums hold beside the
 * clusters: an inverse variance, 0 for none
 * \param[in] solution what \ref moveToFit gave
 * \return NaN where there are too few clusters to tell, or it is beyond numbers */
Eigen::Matrix3d
clusteredCovariance(const FitSums& sums,
                    double guess_weight,
                    const Eigen::Vector3d& solution,
                    const std::vector<FitSums>& clusters);

} // namespace pcl::acmap::labeling
