#pragma once

#include "egomotion_input.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::acmap::bench {

/** \brief A way to find the motion between two views of a sequence. */
struct EgomotionMethod {
  std::string name;

  /** \brief T_target_source, on one thread; nothing where the method itself tells that it
   * failed. */
  std::function<std::optional<Eigen::Isometry3d>(
      const EgomotionSequence& sequence, std::size_t source, std::size_t target)>
      motion;
};

/** \brief pcl::VisualEgomotion, which keeps the last two views.
 * \param[in] refines compare surfaces too */
EgomotionMethod
oursMethod(bool refines);

/** \brief pcl::GeneralizedIterativeClosestPoint from no motion, on points to 6 m depth,
 * one a leaf of 5 cm.
 * \param[in] correspondence_distance metres, at most
 * \param[in] neighbours of a point, whose covariance is its own; PCL's default is 20 */
EgomotionMethod
gicpMethod(double correspondence_distance, int neighbours = 20);

/** \brief pcl::NormalDistributionsTransform from no motion, on the same.
 * \param[in] resolution side of a cell, metres */
EgomotionMethod
ndtMethod(double resolution);

/** \brief How ORB and PnP of OpenCV are called. */
struct OrbSetting {
  int features = 2000;
  int fast_threshold = 20; ///< grey levels that make a corner
  double ratio = 0.8;      ///< of the best and the second distance; 1: mutual best ones
  double tolerance = 3;    ///< pixels, of an inlier
  int least_inliers = 12;  ///< fewer are a failure
};

/** \brief cv::ORB in both views, matched by brute force; points of the target, seen in the
 * source: cv::solvePnPRansac, then refined over its inliers. */
EgomotionMethod
orbMethod(const OrbSetting& setting = {});

} // namespace pcl::acmap::bench
