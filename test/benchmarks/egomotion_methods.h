#pragma once

#include "egomotion_input.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A method that estimates the motion between two views of a sequence. */
struct EgomotionMethod {
  std::string name;

  /** \brief Returns T_target_source, on one thread; nothing if the method reports a
   * failure. */
  std::function<std::optional<Eigen::Isometry3d>(
      const EgomotionSequence& sequence, std::size_t source, std::size_t target)>
      motion;
};

/** \brief pcl::VisualEgomotion, which caches the last two views.
 * \param[in] refines also compares surfaces */
EgomotionMethod
oursMethod(bool refines);

/** \brief pcl::GeneralizedIterativeClosestPoint with identity as the initial guess, on
 * points up to 6 m depth, one per leaf of 5 cm.
 * \param[in] correspondence_distance maximum, metres
 * \param[in] neighbours used for the covariance of a point; PCL's default is 20 */
EgomotionMethod
gicpMethod(double correspondence_distance, int neighbours = 20);

/** \brief pcl::NormalDistributionsTransform with identity as the initial guess, on the
 * same points.
 * \param[in] resolution side of a cell, metres */
EgomotionMethod
ndtMethod(double resolution);

/** \brief Parameters of OpenCV's ORB and PnP. */
struct OrbSetting {
  int features = 2000;
  int fast_threshold = 20; ///< grey levels that define a corner
  double ratio = 0.8;      ///< best by second-best distance; 1: mutual best matches
  double tolerance = 3;    ///< pixels, of an inlier
  int min_inliers = 12;    ///< minimum number of inliers
};

/** \brief cv::ORB in both views with brute-force matching; the points of the target and
 * pixels of the source go to cv::solvePnPRansac, followed by a refinement with the
 * inliers. */
EgomotionMethod
orbMethod(const OrbSetting& setting = {});

} // namespace pcl::acmap::bench
